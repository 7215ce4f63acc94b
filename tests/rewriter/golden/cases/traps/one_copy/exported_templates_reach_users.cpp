// What is private in an exported class, and who uses the class may get: as what his function is given, which the package calls with one
// of its own, too (GivesMessageWithin), as a result, as what is copied or written, by a closure.
#include <node/node.h>

void GivesMessage::run(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
  image_.data.resize(100);
  pub_.publish(image_);
}

void GivesMessageWithin::run(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
  image_.data.resize(100);
  use([](sensor_msgs::Image& image) { image.width = 10; });
  pub_.publish(image_);
}

void GivesArray::run(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
  image_.data.resize(100);
  pub_.publish(image_);
}

void ReturnsAsT::run(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
  image_.data.resize(100);
  pub_.publish(image_);
}

void ReturnsAsAuto::run(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
  image_.data.resize(100);
  pub_.publish(image_);
}

void Copies::run(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
  image_.data.resize(100);
  pub_.publish(image_);
}

void Streams::run(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
  image_.data.resize(100);
  pub_.publish(image_);
}

void GivesByClosure::run(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
  image_.data.resize(100);
  pub_.publish(image_);
}
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class GivesMessage {
 public:
  void run(ros::NodeHandle& nh);
  template <class F>
  void use(F f) {
    f(image_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

class GivesMessageWithin {
 public:
  void run(ros::NodeHandle& nh);
  template <class F>
  void use(F f) {
    f(image_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

class GivesArray {
 public:
  void run(ros::NodeHandle& nh);
  template <class F>
  void use(F f) {
    f(image_.data);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

class ReturnsAsT {
 public:
  void run(ros::NodeHandle& nh);
  template <class T>
  T& get() {
    return image_;
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

class ReturnsAsAuto {
 public:
  void run(ros::NodeHandle& nh);
  auto& get() { return image_; }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

class Copies {
 public:
  void run(ros::NodeHandle& nh);
  template <class T>
  void copy_to(T& other) {
    other = image_;
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

class Streams {
 public:
  void run(ros::NodeHandle& nh);
  template <class Stream>
  void save(Stream& stream) {
    stream << image_;
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

class GivesByClosure {
 public:
  void run(ros::NodeHandle& nh);
  auto visitor() {
    return [this](auto f) { f(image_); };
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:8 sensor_msgs/Image one_copy 'image' TZC1005 a template in a header that other packages may include gives it to what they say
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1005 a template in a header that other packages may include gives it to what they say
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'image' TZC1005 a template in a header that other packages may include gives it to what they say
// advertise src/node.cpp:25 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:27 sensor_msgs/Image one_copy 'image' TZC1005 a template in a header that other packages may include gives it to what they say
// advertise src/node.cpp:31 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:33 sensor_msgs/Image one_copy 'image' TZC1005 'get' is declared in a header that other packages may include
// advertise src/node.cpp:37 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:39 sensor_msgs/Image one_copy 'image' TZC1005 a template in a header that other packages may include gives it to what they say
// advertise src/node.cpp:43 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:45 sensor_msgs/Image one_copy 'image' TZC1005 a template in a header that other packages may include gives it to what they say
// advertise src/node.cpp:49 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:51 sensor_msgs/Image one_copy 'image' TZC1005 a template in a header that other packages may include gives it to what they say
//
// +++ include/node/node.h
// +#include <tzc/ros.h>
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
// -  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
// -  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
// -  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
// -  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
// -  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
// -  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
// -  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
