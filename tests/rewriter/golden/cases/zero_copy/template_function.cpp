// A function template builds the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class Pixel>
void send(ros::Publisher& pub) {
  sensor_msgs::Image image;
  image.data.resize(100 * sizeof(Pixel));
  pub.publish(image);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  send<uint8_t>(pub);
  send<uint16_t>(pub);
}
//--- expected
// publish src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void send(ros::Publisher& pub) {
// -  sensor_msgs::Image image;
// +void send(tzc::Publisher& pub) {
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
