// What the standard library's vector gives comes back at once: no zero-fill.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <cstring>
#include <vector>

void run(ros::NodeHandle& nh, const std::vector<std::vector<uint8_t>>& frames) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  memcpy(&image.data[0], frames[0].data(), 100);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
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
