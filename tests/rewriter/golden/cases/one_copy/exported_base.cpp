// A class of an exported header is a publisher.
#include <node/node.h>

void Sender::connect(ros::NodeHandle& nh) { static_cast<ros::Publisher&>(*this) = nh.advertise<sensor_msgs::Image>("image", 10); }
void run(Sender& sender) {
  sensor_msgs::Image image;
  image.data.resize(100);
  sender.publish(image);
}
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Sender : public ros::Publisher {
 public:
  void connect(ros::NodeHandle& nh);
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise src/node.cpp:4 sensor_msgs/Image one_copy 'image' TZC1009 ported, it would not compile: non-const lvalue reference to type 'tzc::Publisher' cannot bind to a value of unrelated type 'Sender'
// publish src/node.cpp:8 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void Sender::connect(ros::NodeHandle& nh) { static_cast<ros::Publisher&>(*this) = nh.advertise<sensor_msgs::Image>("image", 10); }
// +void Sender::connect(ros::NodeHandle& nh) { static_cast<ros::Publisher&>(*this) = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", 10)); }
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  sender.publish(image);
// +  tzc::publish(sender, image);
