// A free function builds the message, far from its publisher.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

sensor_msgs::Image make() {
  sensor_msgs::Image image;
  image.data.resize(10);
  return image;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  pub.publish(make());
}
//===
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1019 it is built where its publisher can not be named
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10, 0);
