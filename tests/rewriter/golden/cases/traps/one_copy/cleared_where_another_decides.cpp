// What decides whether the ranges are cleared is not what decides whether they are published, or changes in between.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

class Changed {
 public:
  explicit Changed(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::LaserScan>("changed", 1)) {}
  void trace(float range) {
    bool wanted = pub_.getNumSubscribers() > 0;
    if (wanted) scan_.ranges.clear();
    wanted = pub_.getNumSubscribers() > 1;
    if (wanted) scan_.ranges.push_back(range);
    if (wanted) pub_.publish(scan_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::LaserScan scan_;
};

class EachTime {
 public:
  explicit EachTime(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::LaserScan>("each_time", 1)) {}
  void trace(float range) {
    for (int i = 0; i < 9; ++i) {
      const bool first = i == 0;
      if (first) scan_.ranges.clear();
      scan_.ranges.push_back(range);
      if (!first) pub_.publish(scan_);
    }
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::LaserScan scan_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/LaserScan one_copy 'changed'
// publish src/node.cpp:13 sensor_msgs/LaserScan one_copy 'changed' TZC1022 line 12 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:23 sensor_msgs/LaserScan one_copy 'each_time'
// publish src/node.cpp:29 sensor_msgs/LaserScan one_copy 'each_time' TZC1022 line 28 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  explicit Changed(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::LaserScan>("changed", 1)) {}
// +  explicit Changed(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "changed", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::LaserScan scan_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::LaserScan scan_;
// -  explicit EachTime(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::LaserScan>("each_time", 1)) {}
// +  explicit EachTime(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "each_time", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::LaserScan scan_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::LaserScan scan_;
