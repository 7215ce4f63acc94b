// ROS's macros name the function that logs, which is no question of the program.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

void fill(sensor_msgs::LaserScan& scan) {
  ROS_INFO("filling");
  scan.ranges.resize(100);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
  sensor_msgs::LaserScan scan;
  fill(scan);
  pub.publish(scan);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:14 sensor_msgs/LaserScan zero_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -void fill(sensor_msgs::LaserScan& scan) {
// +void fill(tzc::sensor_msgs::LaserScan& scan) {
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
// -  sensor_msgs::LaserScan scan;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "scan", 10);
// +  tzc::sensor_msgs::LaserScan scan;
// +  pub.allocate(scan);
