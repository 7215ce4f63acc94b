// push_back under a condition: the size is known only at the end.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("image", 10);
  sensor_msgs::LaserScan scan;
  for (int i = 0; i < 360; ++i)
    if (i % 3) scan.ranges.push_back(i);
  pub.publish(scan);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/LaserScan zero_copy 'image'
// publish src/node.cpp:10 sensor_msgs/LaserScan zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("image", 10);
// -  sensor_msgs::LaserScan scan;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "image", 10);
// +  tzc::sensor_msgs::LaserScan scan;
// +  pub.allocate(scan);
