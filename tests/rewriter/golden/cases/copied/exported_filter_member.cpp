// A public filter of an exported class.
#include <node/node.h>

Node::Node() { ros::NodeHandle nh; sub_.subscribe(nh, "image", 1); }
//--- include/node/node.h
#pragma once
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
class Node {
 public:
  Node();
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
// subscribe src/node.cpp:4 sensor_msgs/Image copied 'image' TZC1005 the member 'sub_' is part of a header that other packages may include, and message_filters' own class gets a copy, since it may pass it on to a writer
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -Node::Node() { ros::NodeHandle nh; sub_.subscribe(nh, "image", 1); }
// +Node::Node() { ros::NodeHandle nh; tzc::message_filters::subscribe(sub_, nh, "image", 1); }
