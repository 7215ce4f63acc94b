// Classes of another package may use what is private.
#include <node/node.h>

void OfClass::run(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
  image_.data.resize(100);
  pub_.publish(image_);
}

void OfTemplate::run(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
  image_.data.resize(100);
  pub_.publish(image_);
}
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Viewer;
template <class T>
class AnyViewer;

class OfClass {
 public:
  void run(ros::NodeHandle& nh);

 private:
  friend class Viewer;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

class OfTemplate {
 public:
  void run(ros::NodeHandle& nh);

 private:
  template <class T>
  friend class AnyViewer;
  ros::Publisher pub_;
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
// advertise src/node.cpp:5 sensor_msgs/Image one_copy 'image' TZC1005 a friend of its class, which other packages may include, is not defined here
// publish src/node.cpp:7 sensor_msgs/Image one_copy 'image' TZC1005 a friend of its class, which other packages may include, is not defined here
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1005 a friend of its class, which other packages may include, is not defined here
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1005 a friend of its class, which other packages may include, is not defined here
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", 10));
// -  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", 10));
