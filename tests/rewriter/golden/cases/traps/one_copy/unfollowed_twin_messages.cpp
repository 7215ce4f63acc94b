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
