// The factory is also called where no publisher is known.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

sensor_msgs::Image make() {
  sensor_msgs::Image image;
  image.data.resize(10);
  return image;
}

unsigned size() { return make().data.size(); }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  pub.publish(make());
}
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::Image make() {
// -  sensor_msgs::Image image;
// +tzc::sensor_msgs::Image make() {
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
