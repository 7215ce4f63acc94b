// It is a member of an exported class, and a library's object publishes with it besides.
#include <node/node.h>

Driver::Driver(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::LaserScan>("scan", 1);
  diagnosed_.reset(new diagnostic_updater::DiagnosedPublisher<sensor_msgs::LaserScan>(pub_));
}
void Driver::tick(const sensor_msgs::LaserScan& other) {
  sensor_msgs::LaserScan scan;
  scan.ranges.resize(1080);
  pub_.publish(scan);
  diagnosed_->publish(other);
}
void Driver::clear() { pub_.publish(sensor_msgs::LaserScan()); }
//--- include/node/node.h
#pragma once
#include <diagnostic_updater/publisher.h>
#include <sensor_msgs/LaserScan.h>

#include <memory>

class Driver {
 public:
  explicit Driver(ros::NodeHandle& nh);
  void tick(const sensor_msgs::LaserScan& other);
  void clear();

 protected:
  ros::Publisher pub_;
  std::unique_ptr<diagnostic_updater::DiagnosedPublisher<sensor_msgs::LaserScan>> diagnosed_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise src/node.cpp:5 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:11 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:12 sensor_msgs/LaserScan one_copy TZC1021 'diagnostic_updater::DiagnosedPublisher' publishes it
// publish src/node.cpp:14 sensor_msgs/LaserScan one_copy 'scan' TZC1019 where it is built was not found
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  pub_ = nh.advertise<sensor_msgs::LaserScan>("scan", 1);
// +  pub_ = tzc::attached<sensor_msgs::LaserScan>(nh.advertise<sensor_msgs::LaserScan>("scan", 1));
// -  sensor_msgs::LaserScan scan;
// +  tzc::sensor_msgs::LaserScan scan;
// +  tzc::allocate(scan);
// -  pub_.publish(scan);
// +  tzc::publish(pub_, scan);
