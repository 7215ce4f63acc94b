// The use stands in the branch of the publish.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void library(uint8_t* pixels);
void flush();
bool send(ros::Publisher& pub, sensor_msgs::Image& image) {
  pub.publish(image);
  return true;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  library(&image.data[0]);
  if (send(pub, image)) flush();
}
//--- expected
// publish src/node.cpp:8 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'library'
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -bool send(ros::Publisher& pub, sensor_msgs::Image& image) {
// +bool send(tzc::Publisher& pub, sensor_msgs::Image& image) {
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
