// A class of another package may use the message.
#include <node/node.h>

void Node::run() {
  pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
  image_.data.resize(100);
  pub_.publish(image_);
}
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Viewer;

class Node {
 public:
  void run();

 private:
  friend class Viewer;
  ros::Publisher pub_;
  ros::NodeHandle nh_;
  sensor_msgs::Image image_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise src/node.cpp:5 sensor_msgs/Image plain 'image' TZC1005 a friend of its class, which other packages may include, is not defined here
// publish src/node.cpp:7 sensor_msgs/Image plain 'image' TZC1005 a friend of its class, which other packages may include, is not defined here
