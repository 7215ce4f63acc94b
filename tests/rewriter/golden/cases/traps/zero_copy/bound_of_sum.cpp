// Each array is light, both together are not; a macro names two arrays at one place.
//RUN: small=4096
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#define RESIZE_BOTH(scan, n) \
  scan.ranges.resize(n);     \
  scan.intensities.resize(n)

#define TWICE(what) \
  what;             \
  what

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
  sensor_msgs::LaserScan summed;
  summed.ranges.resize(600);
  summed.intensities.resize(600);
  pub.publish(summed);
  sensor_msgs::LaserScan by_macro;
  RESIZE_BOTH(by_macro, 600);
  pub.publish(by_macro);
  sensor_msgs::LaserScan twice;
  TWICE(twice.ranges.push_back(1));
  pub.publish(twice);
}
//--- expected
// advertise src/node.cpp:15 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:19 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:22 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:25 sensor_msgs/LaserScan zero_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
// -  sensor_msgs::LaserScan summed;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "scan", 10);
// +  tzc::sensor_msgs::LaserScan summed;
// +  pub.allocate(summed);
// -  sensor_msgs::LaserScan by_macro;
// +  tzc::sensor_msgs::LaserScan by_macro;
// +  pub.allocate(by_macro);
// -  sensor_msgs::LaserScan twice;
// +  tzc::sensor_msgs::LaserScan twice;
// +  pub.allocate(twice);
