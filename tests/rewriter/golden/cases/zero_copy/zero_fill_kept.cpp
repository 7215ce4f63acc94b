// Zero-fill stays: fewer bytes, wider elements, a condition, another array, a use in between.
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  static const uint8_t pixels[100] = {1};
  const bool really = ros::ok();
  sensor_msgs::Image image, other;
  image.data.resize(100);
  memcpy(&image.data[0], pixels, 50);
  image.data.resize(100);
  if (really) memcpy(&image.data[0], pixels, 100);
  image.data.resize(100);
  memcpy(&other.data[0], pixels, 100);
  image.data.resize(100);
  image.data[99] = image.data[98];
  memcpy(&image.data[0], pixels, 100);
  image.data.resize(100);
  memcpy(&image.data[1], pixels, 100);
  pub.publish(image);
  pub.publish(other);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:22 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// -  sensor_msgs::Image image, other;
// +  tzc::sensor_msgs::Image image, other;
// +  pub.allocate(image);
// +  pub.allocate(other);
