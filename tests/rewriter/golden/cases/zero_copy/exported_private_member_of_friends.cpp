// What is private in an exported class, and all that may use it is seen: a friend is defined in another file of the package, another
// one is a library's, and a template uses only numbers and the array's own functions.
#include <node/node.h>

void Node::run() {
  pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
  image_.data.clear();
  resize(100u);
  pub_.publish(image_);
}
//--- src/worker.cpp
#include <node/node.h>

class Worker {
 public:
  void work(Node& node) { node.image_.width = 10; }
};
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <memory>

class Node {
 public:
  void run();
  template <class T>
  void resize(T size) {
    image_.width = size;
    image_.data.resize(size);
    use(image_.width + size);
  }
  template <class T>
  void use(T) {}

 private:
  friend class Worker;
  friend std::default_delete<Node>;
  ros::Publisher pub_;
  ros::NodeHandle nh_;
  sensor_msgs::Image image_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp src/worker.cpp)
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
//
// +++ include/node/node.h
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::sensor_msgs::Image image_;
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10);
