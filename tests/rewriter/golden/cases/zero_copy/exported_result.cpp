// A publisher is the result of an exported function.
#include <node/node.h>

ros::Publisher connect(ros::NodeHandle& nh) { return nh.advertise<sensor_msgs::Image>("image", 10); }
void run(ros::NodeHandle& nh) {
  ros::Publisher pub = connect(nh);
  sensor_msgs::Image image;
  image.data.resize(100);
  pub.publish(image);
}
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher connect(ros::NodeHandle& nh);
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise src/node.cpp:4 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  pub.publish(image);
// +  tzc::publish(pub, image);
