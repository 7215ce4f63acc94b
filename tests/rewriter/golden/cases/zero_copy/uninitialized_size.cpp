// memcpy of size() bytes; std::fill over all.
#include <algorithm>
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  static const uint8_t pixels[100] = {1};
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->data.resize(100);
  memcpy(&image->data[0], pixels, image->data.size());
  pub.publish(image);
  image->data.resize(200);
  std::fill(image->data.begin(), image->data.end(), 7);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// -  image->data.resize(100);
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +  pub.allocate(*image);
// +  image->data.resize(100, tzc::uninitialized);
// -  image->data.resize(200);
// +  image->data.resize(200, tzc::uninitialized);
