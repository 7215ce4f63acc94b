// Functions of an exported header advertise and keep a copy of the publisher, as a library's do: they stay as they are, and shared memory
// is attached to what they return.
#include <node/base.h>
#include <sensor_msgs/Imu.h>

class Node : public Base {
 public:
  explicit Node(ros::NodeHandle& nh) : nh_(nh) {
    points_ = advertise<sensor_msgs::PointCloud2>(nh_, "points", 1);
    images_ = advertiseImage(nh_, "image", 1);
    imu_ = advertise<sensor_msgs::Imu>(nh_, "imu", 1);
  }
  void step() {
    if (!isSubscribed()) return;
    sensor_msgs::PointCloud2 points;
    points.data.resize(10000);
    points_.publish(points);
    sensor_msgs::Image image;
    image.data.resize(10000);
    images_.publish(image);
    imu_.publish(sensor_msgs::Imu());
  }

 private:
  ros::NodeHandle& nh_;
  ros::Publisher points_, imu_;
  image_transport::Publisher images_;
};
//--- include/node/base.h
#pragma once
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <string>
#include <vector>

class Base {
 public:
  virtual ~Base() {}

 protected:
  template <class M>
  ros::Publisher advertise(ros::NodeHandle& nh, const std::string& topic, int queue) {
    ros::Publisher pub = nh.advertise<M>(topic, queue);
    publishers_.push_back(pub);
    return pub;
  }
  image_transport::Publisher advertiseImage(ros::NodeHandle& nh, const std::string& topic, int queue) {
    image_transport::Publisher pub = image_transport::ImageTransport(nh).advertise(topic, queue);
    image_publishers_.push_back(pub);
    return pub;
  }
  bool isSubscribed() const {
    for (const ros::Publisher& pub : publishers_)
      if (pub.getNumSubscribers() > 0) return true;
    for (const image_transport::Publisher& pub : image_publishers_)
      if (pub.getNumSubscribers() > 0) return true;
    return false;
  }
  std::vector<ros::Publisher> publishers_;
  std::vector<image_transport::Publisher> image_publishers_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs image_transport)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise include/node/base.h:16 sensor_msgs/Imu not_needed
// advertise include/node/base.h:16 sensor_msgs/PointCloud2 not_needed who calls this function attaches shared memory to what it returns
// advertise include/node/base.h:21 sensor_msgs/Image not_needed who calls this function attaches shared memory to what it returns
// advertise src/node.cpp:9 sensor_msgs/PointCloud2 zero_copy 'points'
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:11 sensor_msgs/Imu not_needed 'imu'
// publish src/node.cpp:17 sensor_msgs/PointCloud2 zero_copy 'points'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:21 sensor_msgs/Imu not_needed 'imu'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -    points_ = advertise<sensor_msgs::PointCloud2>(nh_, "points", 1);
// -    images_ = advertiseImage(nh_, "image", 1);
// +    points_ = tzc::attach_publisher<tzc::sensor_msgs::PointCloud2>(advertise<sensor_msgs::PointCloud2>(nh_, "points", 1));
// +    images_ = tzc::image_transport::attach_publisher(advertiseImage(nh_, "image", 1));
// -    sensor_msgs::PointCloud2 points;
// +    tzc::sensor_msgs::PointCloud2 points;
// +    points_.allocate(points);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    images_.allocate(image);
// -  ros::Publisher points_, imu_;
// -  image_transport::Publisher images_;
// +  tzc::Publisher points_;
// +  ros::Publisher imu_;
// +  tzc::image_transport::Publisher images_;
