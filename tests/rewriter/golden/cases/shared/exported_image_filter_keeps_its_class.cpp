// image_transport's filter reads shared memory also where it keeps its class.
#include <node/node.h>

Node::Node(ros::NodeHandle& nh) : it_(nh) {
  image_.registerCallback([](const sensor_msgs::ImageConstPtr&) {});
  image_.subscribe(it_, "image", 1, image_transport::TransportHints("raw"));
}
//--- include/node/node.h
#pragma once
#include <image_transport/subscriber_filter.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh);
  image_transport::SubscriberFilter image_;

 private:
  image_transport::ImageTransport it_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// subscribe src/node.cpp:6 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// -  image_.subscribe(it_, "image", 1, image_transport::TransportHints("raw"));
// +  tzc::message_filters::subscribe(image_, it_, "image", 1, image_transport::TransportHints("raw"));
