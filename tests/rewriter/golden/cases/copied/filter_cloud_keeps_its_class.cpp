// A filter of clouds of PCL that keeps its class: the port needs the header that shares them.
#include <node/node.h>

Node::Node(ros::NodeHandle& nh) { cloud_.subscribe(nh, "cloud", 1); }
//--- include/node/node.h
#pragma once
#include <message_filters/subscriber.h>
#include <pcl/point_cloud.h>
#include <pcl_ros/point_cloud.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh);
  message_filters::Subscriber<pcl::PointCloud<pcl::PointXYZ>> cloud_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// subscribe src/node.cpp:4 sensor_msgs/PointCloud2 copied 'cloud' TZC2010 the callback takes a cloud of PCL, which is made from the shared bytes
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// +#include <tzc/pcl.h>
// -Node::Node(ros::NodeHandle& nh) { cloud_.subscribe(nh, "cloud", 1); }
// +Node::Node(ros::NodeHandle& nh) { tzc::message_filters::subscribe(cloud_, nh, "cloud", 1); }
