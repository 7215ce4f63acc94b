// The class that holds the message grows with it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

struct Frame {
  sensor_msgs::Image image;
};
struct Numbered : Frame {
  int number;
};
struct Sweep {
  int number;
  sensor_msgs::LaserScan scan;
};

class Node {
 public:
  Node() : pool_(65536 / sizeof(Numbered)) {}
  void tick(int k) {
    Numbered& frame = pool_[k % pool_.size()];
    frame.image.data.assign(1000, k);
    pub_.publish(frame.image);
    Sweep sweep;
    sweep.scan.ranges.assign(1000, alignof(Sweep));
    scan_pub_.publish(sweep.scan);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher scan_pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1);
  std::vector<Numbered> pool_;
};
//--- expected
// publish src/node.cpp:23 sensor_msgs/Image one_copy 'image' TZC1001 the program asks for the size of a class that holds it
// publish src/node.cpp:26 sensor_msgs/LaserScan one_copy 'scan' TZC1001 the program asks for the size of a class that holds it
// advertise src/node.cpp:31 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:32 sensor_msgs/LaserScan one_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher scan_pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::Publisher scan_pub_ = tzc::advertise<sensor_msgs::LaserScan>(nh_, "scan", 1);
