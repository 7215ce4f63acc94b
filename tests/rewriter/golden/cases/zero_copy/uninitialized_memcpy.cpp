// All elements are written by the memcpy that follows: no zero-fill.
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  const unsigned size = 100;
  static const uint8_t pixels[size] = {1};
  sensor_msgs::Image image;
  image.data.resize(size);
  image.step = 10;
  memcpy(image.data.data(), pixels, size);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// -  sensor_msgs::Image image;
// -  image.data.resize(size);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// +  image.data.resize(size, tzc::uninitialized);
