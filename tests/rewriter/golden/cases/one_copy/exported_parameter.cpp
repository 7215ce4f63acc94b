// A publisher is a parameter of an exported function.
#include <node/node.h>

void send(ros::Publisher& pub, const sensor_msgs::Image& image) { pub.publish(image); }
void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  send(pub, image);
}
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void send(ros::Publisher& pub, const sensor_msgs::Image& image);
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// publish src/node.cpp:4 sensor_msgs/Image one_copy 'image' TZC1005 'send' is declared in a header that other packages may include
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image' TZC1005 'send' is declared in a header that other packages may include
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  ros::Publisher pub = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", 10));
