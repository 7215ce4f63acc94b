// What is never published needs no memory, and does not decide over what is: a test of the function that fills both.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void fill(unsigned size, sensor_msgs::Image& image) { image.data.resize(size); }

void publish(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  fill(10000, image);
  pub.publish(image);
}

unsigned test() {
  sensor_msgs::Image image;
  fill(5, image);
  unsigned sum = 0;
  for (auto value = image.data.begin(); value != image.data.end(); ++value) sum += *value;
  image.data.clear();
  return sum + image.data.size();
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void fill(unsigned size, sensor_msgs::Image& image) { image.data.resize(size); }
// +void fill(unsigned size, tzc::sensor_msgs::Image& image) { image.data.resize(size); }
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
