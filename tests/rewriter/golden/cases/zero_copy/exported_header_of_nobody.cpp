// The helper is declared in a header that other packages may include, and none does.
//RUN: in-use=include/other.h
#include <ros/ros.h>

#include "fill.h"

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  fill(image);
  pub.publish(image);
}
//--- include/fill.h
#pragma once
#include <sensor_msgs/Image.h>

void fill(sensor_msgs::Image& image);
//--- src/fill.cpp
#include "fill.h"

void fill(sensor_msgs::Image& image) { image.data.resize(10); }
//--- CMakeLists.txt
catkin_package(
  INCLUDE_DIRS include
  LIBRARIES fill
)
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ include/fill.h
// +#include <tzc/sensor_msgs/Image.h>
// -void fill(sensor_msgs::Image& image);
// +void fill(tzc::sensor_msgs::Image& image);
//
// +++ src/fill.cpp
// +#include <tzc/sensor_msgs/Image.h>
// -void fill(sensor_msgs::Image& image) { image.data.resize(10); }
// +void fill(tzc::sensor_msgs::Image& image) { image.data.resize(10); }
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
