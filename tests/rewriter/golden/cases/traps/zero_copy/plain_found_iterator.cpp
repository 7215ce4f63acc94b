// What an algorithm finds is compared, and its distance measured.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  auto found = std::find_if(image.data.begin(), image.data.end(), [](uint8_t pixel) { return pixel > 3; });
  if (found != image.data.end()) *found = 3;
  image.width = std::max_element(image.data.begin(), image.data.end()) - image.data.begin();
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
