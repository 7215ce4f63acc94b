// A function of an exported header advertises, and another one publishes through the member that it keeps: that member's type stays.
#include <node/base.h>

void Base::send() {
  sensor_msgs::Image image;
  image.data.resize(10000);
  publishers_[0].publish(image);
}
ros::Publisher Base::advertise(ros::NodeHandle& nh, const std::string& topic) {
  publishers_.push_back(nh.advertise<sensor_msgs::Image>(topic, 1));
  return publishers_.back();
}
//--- include/node/base.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <string>
#include <vector>

class Base {
 public:
  ros::Publisher advertise(ros::NodeHandle& nh, const std::string& topic);
  void send();

 protected:
  std::vector<ros::Publisher> publishers_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// publish src/node.cpp:7 sensor_msgs/Image zero_copy
// advertise src/node.cpp:10 sensor_msgs/Image not_needed who calls this function attaches shared memory to what it returns
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  publishers_[0].publish(image);
// +  tzc::publish(publishers_[0], image);
