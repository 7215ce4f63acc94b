// One array is made anew, the other one is not.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
  void publish() {
    scan_.ranges.clear();
    scan_.ranges.push_back(1);
    scan_.intensities.push_back(1);
    pub_.publish(scan_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::LaserScan scan_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/LaserScan one_copy 'scan'
// publish src/node.cpp:13 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 12 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 10); }
// -  ros::Publisher pub_;
// -  sensor_msgs::LaserScan scan_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::LaserScan scan_;
