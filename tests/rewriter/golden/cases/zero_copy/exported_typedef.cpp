// A typedef of an exported header names the publisher.
#include <node/node.h>

void run(ros::NodeHandle& nh) {
  Sender pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  pub.publish(image);
}
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

typedef ros::Publisher Sender;
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise src/node.cpp:5 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Sender pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
