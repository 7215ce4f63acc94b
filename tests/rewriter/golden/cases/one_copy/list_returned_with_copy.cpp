// A function returns copies of what it is given, in a vector and in an optional one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <optional>
#include <vector>

std::vector<sensor_msgs::Image> list(const sensor_msgs::Image& image) {
  return {image};
}

std::optional<sensor_msgs::Image> maybe(const sensor_msgs::Image& image) {
  return image;
}

void run(ros::NodeHandle& nh, unsigned n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  ros::Publisher other = nh.advertise<sensor_msgs::Image>("other", 10);
  sensor_msgs::Image frame;
  frame.data.resize(n);
  const std::vector<sensor_msgs::Image> images = list(frame);
  pub.publish(images.front());
  const std::optional<sensor_msgs::Image> image = maybe(frame);
  other.publish(*image);
}
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'other'
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'image' TZC1022 it is a copy (returned from 'list' in line 8), whose elements lie outside shared memory until it is published
// publish src/node.cpp:23 sensor_msgs/Image one_copy 'other' TZC1022 it is a copy (returned from 'maybe' in line 12), whose elements lie outside shared memory until it is published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -std::vector<sensor_msgs::Image> list(const sensor_msgs::Image& image) {
// +std::vector<tzc::sensor_msgs::Image> list(const tzc::sensor_msgs::Image& image) {
// -std::optional<sensor_msgs::Image> maybe(const sensor_msgs::Image& image) {
// +std::optional<tzc::sensor_msgs::Image> maybe(const tzc::sensor_msgs::Image& image) {
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  ros::Publisher other = nh.advertise<sensor_msgs::Image>("other", 10);
// -  sensor_msgs::Image frame;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::Publisher other = tzc::advertise<tzc::sensor_msgs::Image>(nh, "other", 10);
// +  tzc::sensor_msgs::Image frame;
// +  pub.allocate(frame);
// -  const std::vector<sensor_msgs::Image> images = list(frame);
// +  const std::vector<tzc::sensor_msgs::Image> images = list(frame);
// -  const std::optional<sensor_msgs::Image> image = maybe(frame);
// +  const std::optional<tzc::sensor_msgs::Image> image = maybe(frame);
