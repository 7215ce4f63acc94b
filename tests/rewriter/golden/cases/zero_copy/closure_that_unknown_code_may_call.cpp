// What the closure calls may call the closure again, which has a message of its own then.
#include <other/library.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

class Node {
 public:
  Node() {
    sub_ = nh_.subscribe<sensor_msgs::LaserScan>("in", 1, [this](const sensor_msgs::LaserScanConstPtr& in) {
      sensor_msgs::LaserScan out;
      std::string frame;
      frame = in->header.frame_id;
      out.ranges.resize(in->ranges.size());
      unknown();
      pub_.publish(out);
    });
  }

 private:
  void unknown();

  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("out", 1);
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/LaserScan shared 'in'
// publish src/node.cpp:15 sensor_msgs/LaserScan zero_copy 'out'
// advertise src/node.cpp:23 sensor_msgs/LaserScan zero_copy 'out'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -    sub_ = nh_.subscribe<sensor_msgs::LaserScan>("in", 1, [this](const sensor_msgs::LaserScanConstPtr& in) {
// -      sensor_msgs::LaserScan out;
// +    sub_ = tzc::subscribe<sensor_msgs::LaserScan>(nh_, "in", 1, [this](const sensor_msgs::LaserScanConstPtr& in) {
// +      tzc::sensor_msgs::LaserScan out;
// +      pub_.allocate(out);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("out", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "out", 1);
