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
//--- expected
// advertise src/node.cpp:7 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:16 sensor_msgs/LaserScan zero_copy 'scan'
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
