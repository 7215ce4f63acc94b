// A class template of an exported header that advertises what its user says: the publisher is ported, the message is the user's.
#include <node/sender.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  Sender<sensor_msgs::Image> sender;
  sender.open(nh);
  sensor_msgs::Image image;
  image.data.resize(100);
  sender.send(image);
}
//--- include/node/sender.h
#pragma once
#include <ros/ros.h>

template <class M>
class Sender {
 public:
  void open(ros::NodeHandle& nh) { pub_ = nh.advertise<M>("image", 10); }
  void send(const M& message) { pub_.publish(message); }

 private:
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
// advertise include/node/sender.h:7 sensor_msgs/Image one_copy 'image'
// publish include/node/sender.h:8 sensor_msgs/Image one_copy 'image' TZC1005 its type is the parameter 'M' of a class template
//
// +++ include/node/sender.h
// +#include <tzc/ros.h>
// -  void open(ros::NodeHandle& nh) { pub_ = nh.advertise<M>("image", 10); }
// +  void open(ros::NodeHandle& nh) { pub_ = tzc::advertise<M>(nh, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
