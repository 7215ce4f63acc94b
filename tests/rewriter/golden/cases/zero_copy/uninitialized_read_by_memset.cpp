// A zero is what memset writes.
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh, const uint8_t* pixels) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  const sensor_msgs::Image& same = image;
  image.data.resize(100);
  memset(image.data.data(), same.data[5], 100);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// -  const sensor_msgs::Image& same = image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// +  const tzc::sensor_msgs::Image& same = image;
