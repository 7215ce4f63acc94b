// The same of one that keeps its class and has its topic attached; image_transport's filter does not pass messages on so.
#include <node/node.h>

Node::Node(ros::NodeHandle& nh) : it_(nh) {
  filter_.subscribe(nh, "left", 1);
  left_ = nh.subscribe("left", 1, &Node::callback, this);
  image_filter_.subscribe(it_, "right", 1);
  right_ = nh.subscribe("right", 1, &Node::callback, this);
}
//--- include/node/node.h
#pragma once
#include <image_transport/subscriber_filter.h>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh);
  void callback(const sensor_msgs::ImageConstPtr&) {}
  message_filters::Subscriber<sensor_msgs::Image> filter_;
  image_transport::SubscriberFilter image_filter_;

 private:
  image_transport::ImageTransport it_;
  ros::Subscriber left_, right_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// subscribe src/node.cpp:5 sensor_msgs/Image copied 'left' TZC1005 the member 'filter_' is part of a header that other packages may include, and message_filters' own class gets a copy, since it may pass it on to a writer
// subscribe src/node.cpp:6 sensor_msgs/Image copied 'left' TZC2001 an unported filter of the topic may pass the message to a writer, so all callbacks get copies
// subscribe src/node.cpp:7 sensor_msgs/Image shared 'right'
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'right'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/message_filters.h>
// +#include <tzc/ros.h>
// -  filter_.subscribe(nh, "left", 1);
// -  left_ = nh.subscribe("left", 1, &Node::callback, this);
// -  image_filter_.subscribe(it_, "right", 1);
// -  right_ = nh.subscribe("right", 1, &Node::callback, this);
// +  tzc::message_filters::subscribe(filter_, nh, "left", 1);
// +  left_ = tzc::subscribe(nh, "left", 1, &Node::callback, this);
// +  tzc::message_filters::subscribe(image_filter_, it_, "right", 1);
// +  right_ = tzc::subscribe(nh, "right", 1, &Node::callback, this);
