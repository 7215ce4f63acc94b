// The function that publishes it returns it: what escaped there writes before the caller's object ends.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void library(uint8_t* pixels);
void flush();

sensor_msgs::Image shoot(ros::Publisher& pub) {
  sensor_msgs::Image image;
  image.data.resize(100);
  library(&image.data[0]);
  pub.publish(image);
  return image;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image = shoot(pub);
  flush();
  pub.publish(image);
}
//--- expected
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'library'
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:20 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'library'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -sensor_msgs::Image shoot(ros::Publisher& pub) {
// +sensor_msgs::Image shoot(tzc::Publisher& pub) {
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
