// The function gets messages that are ported, one of which may be the one that is published: nothing follows which it writes to.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

class Node {
 public:
  Node() : frames_(3) {}
  void tick() {
    frames_[0].ranges.clear();
    frames_[0].ranges.resize(100);
    pub_.publish(frames_[0]);
    mark(frames_);
  }

 private:
  static void mark(std::vector<sensor_msgs::LaserScan>& frames) {
    for (auto& frame : frames) frame.ranges[0] = 1;
  }
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("frames", 1);
  std::vector<sensor_msgs::LaserScan> frames_;
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/LaserScan one_copy 'frames' TZC1022 line 14 of node.cpp uses a sensor_msgs/LaserScan, and nothing shows which: it may be this one, and be written to after this publish
// advertise src/node.cpp:22 sensor_msgs/LaserScan one_copy 'frames'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  static void mark(std::vector<sensor_msgs::LaserScan>& frames) {
// +  static void mark(std::vector<tzc::sensor_msgs::LaserScan>& frames) {
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("frames", 1);
// -  std::vector<sensor_msgs::LaserScan> frames_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "frames", 1);
// +  std::vector<tzc::sensor_msgs::LaserScan> frames_;
