// A function publishes what it is given.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void send(ros::Publisher& pub, const sensor_msgs::Image& image) {
  pub.publish(image);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->data.resize(100);
  uint8_t* first = &image->data[0];
  send(pub, *image);
  *first = 1;
}
//--- expected
// publish src/node.cpp:6 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -void send(ros::Publisher& pub, const sensor_msgs::Image& image) {
// +void send(tzc::Publisher& pub, const sensor_msgs::Image& image) {
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
