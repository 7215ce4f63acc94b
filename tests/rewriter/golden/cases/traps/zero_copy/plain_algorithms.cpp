// Algorithms of the standard library.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <algorithm>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::fill(image.data.begin(), image.data.end(), 1);
  std::transform(image.data.begin(), image.data.end(), image.data.begin(), [](uint8_t v) { return v + 1; });
  image.height = *std::max_element(image.data.begin(), image.data.end());
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// -  image.data.resize(100);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// +  image.data.resize(100, tzc::uninitialized);
