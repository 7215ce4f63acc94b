// A free function of an exported header advertises. A function of the package's own source is ported with its callers instead.
#include <node/connect.h>

namespace {
ros::Publisher advertise_inside(ros::NodeHandle& nh) { return nh.advertise<sensor_msgs::Image>("inside", 1); }
}  // namespace

void run(ros::NodeHandle& nh) {
  ros::Publisher outside = advertise_image<sensor_msgs::Image>(nh), inside = advertise_inside(nh);
  sensor_msgs::Image image;
  image.data.resize(10000);
  outside.publish(image);
  sensor_msgs::Image other;
  other.data.resize(10000);
  inside.publish(other);
}
//--- include/node/connect.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class M>
ros::Publisher advertise_image(ros::NodeHandle& nh) {
  return nh.advertise<M>("outside", 1);
}
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise include/node/connect.h:7 sensor_msgs/Image not_needed 'outside' who calls this function attaches shared memory to what it returns
// advertise src/node.cpp:5 sensor_msgs/Image zero_copy 'inside'
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy
// publish src/node.cpp:12 sensor_msgs/Image zero_copy
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'inside'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -ros::Publisher advertise_inside(ros::NodeHandle& nh) { return nh.advertise<sensor_msgs::Image>("inside", 1); }
// +tzc::Publisher advertise_inside(ros::NodeHandle& nh) { return tzc::advertise<tzc::sensor_msgs::Image>(nh, "inside", 1); }
// -  ros::Publisher outside = advertise_image<sensor_msgs::Image>(nh), inside = advertise_inside(nh);
// -  sensor_msgs::Image image;
// +  tzc::Publisher outside = tzc::attach_publisher<tzc::sensor_msgs::Image>(advertise_image<sensor_msgs::Image>(nh)), inside = advertise_inside(nh);
// +  tzc::sensor_msgs::Image image;
// +  outside.allocate(image);
// -  sensor_msgs::Image other;
// +  tzc::sensor_msgs::Image other;
// +  inside.allocate(other);
