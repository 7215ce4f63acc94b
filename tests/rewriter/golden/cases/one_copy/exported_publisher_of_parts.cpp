// A publisher of an exported class publishes parts of structures. A later run sees the same.
#include <node/node.h>

struct Frame {
  sensor_msgs::Image image;
};
static void send(Node& node, Frame& frame) { node.pub.publish(frame.image); }

void Node::given() {
  Frame first, second;
  first.image.data.resize(100);
  second.image.data.resize(100);
  send(*this, first);
  send(*this, second);
}
void Node::own() {
  Frame frame;
  frame.image.data.resize(100);
  pub.publish(frame.image);
}
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub(nh.advertise<sensor_msgs::Image>("image", 1)) {}
  void given();
  void own();
  ros::Publisher pub;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise include/node/node.h:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:7 sensor_msgs/Image one_copy 'image' TZC1022 'frame' may be another object each time, with content outside shared memory
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -static void send(Node& node, Frame& frame) { node.pub.publish(frame.image); }
// +static void send(Node& node, Frame& frame) { tzc::publish(node.pub, frame.image); }
// +  tzc::allocate(frame.image);
// -  pub.publish(frame.image);
// +  tzc::publish(pub, frame.image);
