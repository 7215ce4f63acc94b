// A vector that nobody points to gives its elements.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <algorithm>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::vector<uint8_t> pixels(100, 1);
  pixels[0] = 2;
  std::fill(pixels.begin(), pixels.end(), 3);
  image.data = std::move(pixels);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1022 line 13 gives it elements that lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
