// A generic lambda passes the publisher on; the type of its other argument is not known there.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void send(const ros::Publisher& pub, int size) {
  sensor_msgs::Image image;
  image.data.resize(size);
  pub.publish(image);
}
void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  auto call = [&pub](auto& size) { send(pub, size); };
  int size = 100;
  call(size);
}
//--- expected
// publish src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void send(const ros::Publisher& pub, int size) {
// -  sensor_msgs::Image image;
// +void send(const tzc::Publisher& pub, int size) {
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
