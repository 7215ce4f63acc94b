// One instance overwrites all that it resizes, and another a third: the zeros stay for both.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cstring>

constexpr int kPixels = 640 * 480;

template <int planes>
void send(ros::Publisher& pub, const uint8_t* luma) {
  sensor_msgs::Image image;
  image.height = 480 * planes;
  image.width = image.step = 640;
  image.data.resize(planes * kPixels);  // chroma planes, where there are any, stay 0
  std::memcpy(&image.data[0], luma, kPixels);
  pub.publish(image);
}

void run(ros::NodeHandle& nh, const uint8_t* luma) {
  ros::Publisher gray = nh.advertise<sensor_msgs::Image>("gray", 1);
  ros::Publisher yuv = nh.advertise<sensor_msgs::Image>("yuv", 1);
  send<1>(gray, luma);
  send<3>(yuv, luma);
}
//--- expected
// publish src/node.cpp:16 sensor_msgs/Image zero_copy
// advertise src/node.cpp:20 sensor_msgs/Image zero_copy 'gray'
// advertise src/node.cpp:21 sensor_msgs/Image zero_copy 'yuv'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void send(ros::Publisher& pub, const uint8_t* luma) {
// -  sensor_msgs::Image image;
// +void send(tzc::Publisher& pub, const uint8_t* luma) {
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  ros::Publisher gray = nh.advertise<sensor_msgs::Image>("gray", 1);
// -  ros::Publisher yuv = nh.advertise<sensor_msgs::Image>("yuv", 1);
// +  tzc::Publisher gray = tzc::advertise<tzc::sensor_msgs::Image>(nh, "gray", 1);
// +  tzc::Publisher yuv = tzc::advertise<tzc::sensor_msgs::Image>(nh, "yuv", 1);
