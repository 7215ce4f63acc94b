// A function of the package fills the message: ported with its callers.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void fill(sensor_msgs::Image& image, unsigned size) {
  image.data.resize(size);
  for (unsigned i = 0; i < size; ++i) image.data[i] = i;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  fill(image, 100);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void fill(sensor_msgs::Image& image, unsigned size) {
// -  image.data.resize(size);
// +void fill(tzc::sensor_msgs::Image& image, unsigned size) {
// +  image.data.resize(size, tzc::uninitialized);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
