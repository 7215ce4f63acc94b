// What the message is copied to is given by the user.
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

class Node {
 public:
  void run();
  template <class T>
  void copy_to(T& other) {
    other = image_;
  }

 private:
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
// advertise src/node.cpp:5 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:7 sensor_msgs/Image one_copy 'image' TZC1005 a template in a header that other packages may include gives it to what they say
//
// +++ include/node/node.h
// +#include <tzc/ros.h>
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10);
