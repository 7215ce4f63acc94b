// Copies whose types are deduced, or named, and of which nothing is asked that an array does not answer in the same way.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

struct Frame {
  std::vector<uint8_t> pixels;
  std::string name;
};

template <class T>
std::size_t zeros(T values) {
  return std::count(values.begin(), values.end(), 0);
}

std::function<std::size_t()> later;

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  auto sorted = image.data;
  std::sort(sorted.begin(), sorted.end());
  image.width = sorted[50] + zeros(image.data);
  Frame frame{std::vector<uint8_t>(image.data), "frame"};
  later = [pixels = image.data] { return pixels.size(); };
  image.data = sorted;
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:23 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:32 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
