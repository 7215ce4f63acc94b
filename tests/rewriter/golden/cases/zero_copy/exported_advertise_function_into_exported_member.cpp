// What a function of an exported header advertises is kept in a member that stays, too: publishing attaches shared memory.
#include <node/base.h>

class Node : public Base {
 public:
  explicit Node(ros::NodeHandle& nh) { pub_ = advertise<sensor_msgs::Image>(nh, "image"); }
  void step() {
    sensor_msgs::Image image;
    image.data.resize(10000);
    pub_.publish(image);
  }
};
//--- include/node/base.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <string>

class Base {
 protected:
  template <class M>
  ros::Publisher advertise(ros::NodeHandle& nh, const std::string& topic) {
    return nh.advertise<M>(topic, 1);
  }
  ros::Publisher pub_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise include/node/base.h:10 sensor_msgs/Image not_needed who calls this function attaches shared memory to what it returns
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    pub_.publish(image);
// +    tzc::publish(pub_, image);
