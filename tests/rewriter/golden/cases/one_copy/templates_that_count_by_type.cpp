// One counter for each type: the port would begin one of its own.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

template <class M>
uint32_t next() {
  static uint32_t n = 0;
  return ++n;
}
template <class M>
void stamp(M& message) {
  message.header.seq = next<M>();
}
template <class M>
struct Tracker {
  static int count;
};
template <class M>
int Tracker<M>::count = 0;
template <class M>
void track(M& message) {
  Tracker<M> tracker;
  message.header.seq = ++tracker.count;
}

class Node {
 public:
  void tick() {
    sensor_msgs::Image image;
    stamp(image);
    image.data.resize(100);
    pub_.publish(image);
    sensor_msgs::LaserScan scan;
    track(scan);
    scan.ranges.resize(100);
    scan_pub_.publish(scan);
    ROS_INFO("%u %d", next<sensor_msgs::Image>(), Tracker<sensor_msgs::LaserScan>::count);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher scan_pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1);
};
//--- expected
// publish src/node.cpp:33 sensor_msgs/Image one_copy 'image' TZC1001 'stamp' asks for its type
// publish src/node.cpp:37 sensor_msgs/LaserScan one_copy 'scan' TZC1001 'track' asks for its type
// advertise src/node.cpp:43 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:44 sensor_msgs/LaserScan one_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher scan_pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::Publisher scan_pub_ = tzc::advertise<sensor_msgs::LaserScan>(nh_, "scan", 1);
