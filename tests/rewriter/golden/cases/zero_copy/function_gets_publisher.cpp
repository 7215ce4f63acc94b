// A free function gets the publisher and the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void send(const ros::Publisher& pub, sensor_msgs::Image& image) {
  image.header.seq++;
  pub.publish(image);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  send(pub, image);
}
//--- expected
// publish src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void send(const ros::Publisher& pub, sensor_msgs::Image& image) {
// +void send(const tzc::Publisher& pub, tzc::sensor_msgs::Image& image) {
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
