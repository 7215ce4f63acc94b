// The publisher is a parameter.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void send(ros::Publisher pub) {
  sensor_msgs::Image image;
  image.data.resize(1);
  pub.publish(image);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  send(pub);
}
//--- expected
// publish src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void send(ros::Publisher pub) {
// -  sensor_msgs::Image image;
// +void send(tzc::Publisher pub) {
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
