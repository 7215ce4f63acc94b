// A zero is read by an accessor.
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

uint8_t first = 1;

void run(ros::NodeHandle& nh, const uint8_t* pixels) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  const auto& bytes = image.data;
  image.data.resize(100);
  first = bytes.front();
  memcpy(image.data.data(), pixels, 100);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
