// Free functions build the message, far from its publisher: they are given it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

sensor_msgs::Image make(int size = 1, int value = 2);

static sensor_msgs::ImagePtr wrapped() {
  sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>(make(7));
  return image;
}

sensor_msgs::Image make(int size, int value) {
  sensor_msgs::Image image;
  image.data.resize(size, value);
  return image;
}

static sensor_msgs::Image twice() { return make(3, 4); }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  pub.publish(make());
  pub.publish(make(5));
  pub.publish(twice());
}
//--- expected
// advertise src/node.cpp:21 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:22 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::Image make(int size = 1, int value = 2);
// +tzc::sensor_msgs::Image make(const tzc::Publisher& publisher, int size = 1, int value = 2);
// -static sensor_msgs::ImagePtr wrapped() {
// -  sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>(make(7));
// +static tzc::sensor_msgs::ImagePtr wrapped(const tzc::Publisher& publisher) {
// +  tzc::sensor_msgs::ImagePtr image = boost::make_shared<tzc::sensor_msgs::Image>(make(publisher, 7));
// -sensor_msgs::Image make(int size, int value) {
// -  sensor_msgs::Image image;
// +tzc::sensor_msgs::Image make(const tzc::Publisher& publisher, int size, int value) {
// +  tzc::sensor_msgs::Image image;
// +  publisher.allocate(image);
// -static sensor_msgs::Image twice() { return make(3, 4); }
// +static tzc::sensor_msgs::Image twice(const tzc::Publisher& publisher) { return make(publisher, 3, 4); }
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  pub.publish(make());
// -  pub.publish(make(5));
// -  pub.publish(twice());
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  pub.publish(make(pub));
// +  pub.publish(make(pub, 5));
// +  pub.publish(twice(pub));
