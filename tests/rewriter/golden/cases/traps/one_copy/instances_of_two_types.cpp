// Two instances of a template give one place two types: written as the first, an image would go out as a compressed one.
#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

struct Raw {
  typedef sensor_msgs::Image Message;
};
struct Jpeg {
  typedef sensor_msgs::CompressedImage Message;
};

template <class Format>
void send(ros::Publisher& pub, const std::vector<uint8_t>& bytes) {
  typename Format::Message message;
  message.header.stamp = ros::Time::now();
  message.data.assign(bytes.begin(), bytes.end());
  pub.publish(message);
}

void run(ros::NodeHandle& nh, const std::vector<uint8_t>& pixels, const std::vector<uint8_t>& file) {
  ros::Publisher raw = nh.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher jpeg = nh.advertise<sensor_msgs::CompressedImage>("image/compressed", 1);
  send<Raw>(raw, pixels);
  send<Jpeg>(jpeg, file);
}
//--- expected
// publish src/node.cpp:18 sensor_msgs/CompressedImage one_copy TZC1007 its type differs between the instances of a template, or the ways in which the file is compiled
// publish src/node.cpp:18 sensor_msgs/Image one_copy TZC1007 its type differs between the instances of a template, or the ways in which the file is compiled
// advertise src/node.cpp:22 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:23 sensor_msgs/CompressedImage one_copy 'image/compressed'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -void send(ros::Publisher& pub, const std::vector<uint8_t>& bytes) {
// +void send(tzc::Publisher& pub, const std::vector<uint8_t>& bytes) {
// -  ros::Publisher raw = nh.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher jpeg = nh.advertise<sensor_msgs::CompressedImage>("image/compressed", 1);
// +  tzc::Publisher raw = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
// +  tzc::Publisher jpeg = tzc::advertise<sensor_msgs::CompressedImage>(nh, "image/compressed", 1);
