// A package with a directory called tzc.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include "tzc/helper.h"

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(company::size());
  pub.publish(image);
}
//--- include/tzc/helper.h
#pragma once
namespace company {
inline int size() { return 100; }
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
