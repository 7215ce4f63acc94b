// Two arrays resized in a row.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("image", 10);
  sensor_msgs::LaserScan scan;
  scan.ranges.resize(360);
  scan.intensities.resize(360);
  for (int i = 0; i < 360; ++i) scan.ranges[i] = scan.intensities[i] = i;
  pub.publish(scan);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/LaserScan zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/LaserScan zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("image", 10);
// -  sensor_msgs::LaserScan scan;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "image", 10);
// +  tzc::sensor_msgs::LaserScan scan;
// +  pub.allocate(scan);
