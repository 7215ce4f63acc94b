// The options have the type: what is written for one instance would hold for those of other packages.
#include <node/node.h>

struct Images : Base<sensor_msgs::Image> {
  explicit Images(ros::NodeHandle& nh) : Base(nh) {}
  void tick(const sensor_msgs::Image& image) { send(pub_, image); }
};
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class M>
class Base {
 public:
  explicit Base(ros::NodeHandle& nh) {
    ros::AdvertiseOptions options;
    options.init<M>("topic", 1);
    pub_ = nh.advertise(options);
  }

 protected:
  template <class Publisher>
  void send(Publisher& publisher, const M& message) {
    publisher.publish(message);
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
// advertise include/node/node.h:11 sensor_msgs/Image plain TZC1012 the options of this call say what is advertised
// publish include/node/node.h:17 sensor_msgs/Image plain TZC1012 the options of this call say what is advertised
