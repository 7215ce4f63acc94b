// What is written in between are numbers that are no elements: no zero-fill.
#include <cmath>
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <string>
#include <vector>

struct Frame {
  int rows, cols;
  std::vector<uint8_t> pixels;
};

void run(ros::NodeHandle& nh, const Frame& frame, const std::string& name) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  const unsigned size = 100;
  image->data.resize(size);
  image->height = frame.rows;
  image->width = static_cast<unsigned>(std::abs(frame.cols)) + 1;
  image->step = name.size() * 3;
  memcpy(&image->data[0], &frame.pixels[0], size);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +  pub.allocate(*image);
// -  image->data.resize(size);
// +  image->data.resize(size, tzc::uninitialized);
