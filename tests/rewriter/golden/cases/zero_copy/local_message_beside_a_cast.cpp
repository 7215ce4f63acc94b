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
    if (last_ == static_cast<sensor_msgs::LaserScan*>(nullptr)) scan_.ranges.resize(n);
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
