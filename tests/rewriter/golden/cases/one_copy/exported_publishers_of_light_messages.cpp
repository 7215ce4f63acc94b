// What is light stays as it is, also beside another one in a container that stays.
//RUN: small=4096
#include <node/node.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/PointCloud2.h>

Node::Node(ros::NodeHandle& nh) {
  pubs_.push_back(nh.advertise<sensor_msgs::CameraInfo>("info", 1));
  pubs_.push_back(nh.advertise<sensor_msgs::PointCloud2>("cloud", 1));
}
void Node::tick(const sensor_msgs::PointCloud2& cloud) {
  pubs_[0].publish(sensor_msgs::CameraInfo());
  pubs_[1].publish(cloud);
}
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <vector>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh);
  void tick(const sensor_msgs::PointCloud2& cloud);

 protected:
  std::vector<ros::Publisher> pubs_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise src/node.cpp:8 sensor_msgs/CameraInfo not_needed 'info' its arrays are light by their type
// advertise src/node.cpp:9 sensor_msgs/PointCloud2 one_copy 'cloud' TZC1005 the member 'pubs_' is part of a header that other packages may include
// publish src/node.cpp:12 sensor_msgs/CameraInfo not_needed its arrays are light by their type
// publish src/node.cpp:13 sensor_msgs/PointCloud2 one_copy TZC1005 'tick' is declared in a header that other packages may include
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  pubs_.push_back(nh.advertise<sensor_msgs::PointCloud2>("cloud", 1));
// +  pubs_.push_back(tzc::attached<sensor_msgs::PointCloud2>(nh.advertise<sensor_msgs::PointCloud2>("cloud", 1)));
