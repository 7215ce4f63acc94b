// A raw pointer may hold anything where it is not used: it cannot be asked earlier.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void publish(ros::Publisher* pub, bool wanted) {
  sensor_msgs::Image image;
  image.data.resize(1);
  if (wanted) pub->publish(image);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  publish(&pub, true);
}
//--- expected
// publish src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void publish(ros::Publisher* pub, bool wanted) {
// -  sensor_msgs::Image image;
// +void publish(tzc::Publisher* pub, bool wanted) {
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
