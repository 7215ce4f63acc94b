// Nothing but their names lead to local messages: what a cast finds by user data is another one. Null pointers and casts between
// related classes find none either.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

struct Sweep : sensor_msgs::LaserScan {};

size_t size_at(void* user) { return static_cast<sensor_msgs::Image*>(user)->data.size(); }
size_t size_of(Sweep& sweep) { return static_cast<sensor_msgs::LaserScan&>(sweep).ranges.size(); }

class Node {
 public:
  void step(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    images_.publish(image);
    scan_.ranges.assign(n, 0);
    if (last_ == static_cast<sensor_msgs::LaserScan*>(nullptr)) scan_.angle_min = 0;
    scans_.publish(scan_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher images_ = nh_.advertise<sensor_msgs::Image>("image", 10);
  ros::Publisher scans_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10);
  const void* last_ = nullptr;
  sensor_msgs::LaserScan scan_;
};
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:20 sensor_msgs/LaserScan zero_copy 'scan'
// advertise src/node.cpp:25 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:26 sensor_msgs/LaserScan zero_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    images_.allocate(image);
// -  ros::Publisher images_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// -  ros::Publisher scans_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10);
// +  tzc::Publisher images_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10);
// +  tzc::Publisher scans_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 10);
// -  sensor_msgs::LaserScan scan_;
// +  tzc::sensor_msgs::LaserScan scan_;
