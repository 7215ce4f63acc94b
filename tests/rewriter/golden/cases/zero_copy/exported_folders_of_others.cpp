// Folders that are exported, but are other packages' or made by the build.
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
set(COMPONENTS roscpp image_geometry)
find_package(catkin REQUIRED COMPONENTS ${COMPONENTS})
find_package(Eigen3 REQUIRED)
find_package(Qt5 COMPONENTS Widgets)
pkg_check_modules(UVC libuvc)
catkin_package(INCLUDE_DIRS ${EIGEN3_INCLUDE_DIRS} ${Qt5Widgets_INCLUDE_DIRS} ${UVC_INCLUDE_DIRS}
  ${image_geometry_INCLUDE_DIRS} ${catkin_INCLUDE_DIRS} ${CATKIN_DEVEL_PREFIX}/include)
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
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
