// Other names of an array, through which it is read and written between publishes, but not while something points into it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

int value();

template <class Pixels>
void paint(Pixels& pixels) {
  std::fill(pixels.begin(), pixels.end(), 7);
  pixels[3] = value();
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  auto& pixels = image.data;
  const auto& read = image.data;
  pixels.resize(100);
  paint(pixels);
  pixels[read[1]] = read[0] + value();
  image.width = *std::max_element(read.begin(), read.end());
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
