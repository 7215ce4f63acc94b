// The type comes from a macro.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define IMAGE sensor_msgs::Image

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  IMAGE image;
  image.data.resize(10);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1006 its type is written by a macro
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
