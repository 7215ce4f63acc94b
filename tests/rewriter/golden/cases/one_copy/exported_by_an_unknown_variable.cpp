// A variable that an included file may set names the exported folder.
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
include(cmake/folders.cmake)
find_package(catkin REQUIRED COMPONENTS roscpp)
catkin_package(
  INCLUDE_DIRS ${fill_INCLUDE_DIRS}
  LIBRARIES fill
)
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1005 'fill' is declared in a header that other packages may include
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
