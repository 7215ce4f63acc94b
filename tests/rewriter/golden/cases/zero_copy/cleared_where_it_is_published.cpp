// One variable decides whether the ranges are cleared, filled and published.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

class Layer {
 public:
  explicit Layer(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::LaserScan>("scan", 1)) {}
  void trace(int count) {
    const bool wanted = pub_.getNumSubscribers() > 0;
    if (wanted) scan_.ranges.clear();
    for (int i = 0; i < count; ++i) {
      const float range = 0.1f * i;
      if (wanted) scan_.ranges.push_back(range);
    }
    if (!wanted) return;
    pub_.publish(scan_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::LaserScan scan_;
};

class Switched {
 public:
  explicit Switched(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::LaserScan>("switched", 1)) {}
  void trace(int count) {
    if (debug_) scan_.ranges.clear();
    for (int i = 0; i < count; ++i)
      if (debug_) scan_.ranges.push_back(0.1f * i);
    if (debug_) pub_.publish(scan_);
  }

 private:
  ros::Publisher pub_;
  bool debug_ = true;
  sensor_msgs::LaserScan scan_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:16 sensor_msgs/LaserScan zero_copy 'scan'
// advertise src/node.cpp:26 sensor_msgs/LaserScan zero_copy 'switched'
// publish src/node.cpp:31 sensor_msgs/LaserScan zero_copy 'switched'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  explicit Layer(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::LaserScan>("scan", 1)) {}
// +  explicit Layer(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "scan", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::LaserScan scan_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::LaserScan scan_;
// -  explicit Switched(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::LaserScan>("switched", 1)) {}
// +  explicit Switched(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "switched", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  sensor_msgs::LaserScan scan_;
// +  tzc::sensor_msgs::LaserScan scan_;
