// The helper is also called through its address.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void fill(sensor_msgs::Image& image) { image.data.resize(10); }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  void (*filler)(sensor_msgs::Image&) = fill;
  sensor_msgs::Image image;
  fill(image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1005 it is a parameter of 'fill', which other code calls
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
