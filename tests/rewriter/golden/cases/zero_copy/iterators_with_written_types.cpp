// Iterators as C++03 writes them.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(n);
  for (std::vector<uint8_t>::iterator byte = image.data.begin(); byte != image.data.end(); ++byte) *byte = 1;
  std::vector<uint8_t>::iterator at = image.data.begin(), end = image.data.end();
  for (; at != end; ++at) *at += 1;
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  for (std::vector<uint8_t>::iterator byte = image.data.begin(); byte != image.data.end(); ++byte) *byte = 1;
// -  std::vector<uint8_t>::iterator at = image.data.begin(), end = image.data.end();
// +  for (auto byte = image.data.begin(); byte != image.data.end(); ++byte) *byte = 1;
// +  auto at = image.data.begin(), end = image.data.end();
