// A constructor subscribes a filter that keeps its class: there is no call that could attach its topic.
#include <node/node.h>

Node::Node(ros::NodeHandle& nh) : sub_(nh, "image", 1) {}
//--- include/node/node.h
#pragma once
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh);
  message_filters::Subscriber<sensor_msgs::Image> sub_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// subscribe src/node.cpp:4 sensor_msgs/Image plain 'image' TZC1005 the member 'sub_' is part of a header that other packages may include
