// memcpy counts bytes: a float array is not wholly written by size() of them.
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("image", 10);
  static const float values[100] = {1};
  sensor_msgs::LaserScan scan;
  scan.ranges.resize(100);
  memcpy(&scan.ranges[0], values, scan.ranges.size());
  scan.intensities.resize(100);
  memcpy(&scan.intensities[0], values, 100 * sizeof(float));
  pub.publish(scan);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/LaserScan zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/LaserScan zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "image", 10);
// -  sensor_msgs::LaserScan scan;
// +  tzc::sensor_msgs::LaserScan scan;
// +  pub.allocate(scan);
