// A templated publish function: one site for each type.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

template <class M>
void send(const ros::Publisher& pub, const M& message) {
  pub.publish(message);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
  ros::Publisher scans = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  send(images, image);
  sensor_msgs::LaserScan scan;
  scan.ranges.resize(100);
  send(scans, scan);
}
//--- expected
// publish src/node.cpp:8 sensor_msgs/Image zero_copy
// publish src/node.cpp:8 sensor_msgs/LaserScan zero_copy
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:13 sensor_msgs/LaserScan zero_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -void send(const ros::Publisher& pub, const M& message) {
// +void send(const tzc::Publisher& pub, const M& message) {
// -  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
// -  ros::Publisher scans = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher images = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::Publisher scans = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "scan", 10);
// +  tzc::sensor_msgs::Image image;
// +  images.allocate(image);
// -  sensor_msgs::LaserScan scan;
// +  tzc::sensor_msgs::LaserScan scan;
// +  scans.allocate(scan);
