// A pure virtual function of an exported class takes the publisher.
#include <node/node.h>

class Mine : public Sink {
 public:
  void attach(ros::Publisher pub) override { pub_ = pub; }
  void send() {
    sensor_msgs::Image image;
    image.data.resize(100);
    pub_.publish(image);
  }
 private:
  ros::Publisher pub_;
};
void run(ros::NodeHandle& nh, Mine& mine) { mine.attach(nh.advertise<sensor_msgs::Image>("image", 10)); mine.send(); }
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Sink {
 public:
  virtual ~Sink() = default;
  virtual void attach(ros::Publisher pub) = 0;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    pub_.publish(image);
// +    tzc::publish(pub_, image);
