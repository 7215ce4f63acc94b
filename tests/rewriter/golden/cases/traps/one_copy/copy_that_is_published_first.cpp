// Nothing has published the message when its copies are made.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

namespace {

sensor_msgs::Image copy(const sensor_msgs::Image& image) {
  return image;
}

void send(const ros::Publisher& pub, const sensor_msgs::Image& image) {
  pub.publish(copy(image));
}

}  // namespace

void tick(ros::NodeHandle& nh, int count) {
  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  static ros::Publisher copy_pub = nh.advertise<sensor_msgs::Image>("copy", 1);
  sensor_msgs::Image image;
  image.data.assign(count, 1);
  send(copy_pub, image);
  pub.publish(image);
}
//--- expected
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'copy' TZC1022 it is a copy (made in line 8), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'copy'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::Image copy(const sensor_msgs::Image& image) {
// +tzc::sensor_msgs::Image copy(const tzc::sensor_msgs::Image& image) {
// -void send(const ros::Publisher& pub, const sensor_msgs::Image& image) {
// +void send(const tzc::Publisher& pub, const tzc::sensor_msgs::Image& image) {
// -  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// -  static ros::Publisher copy_pub = nh.advertise<sensor_msgs::Image>("copy", 1);
// -  sensor_msgs::Image image;
// +  static tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  static tzc::Publisher copy_pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "copy", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
