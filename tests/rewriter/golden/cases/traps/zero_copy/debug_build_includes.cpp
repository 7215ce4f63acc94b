// Only a debug build includes the header whose function would take another type, and calls it in assert().
//RUN: flags=-DNDEBUG
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cassert>

#ifndef NDEBUG
#include "checks.h"
#endif

int width_of(const sensor_msgs::Image& image) {
  assert(is_valid(image));
  return static_cast<int>(image.width);
}
//--- src/checks.h
#pragma once
#include <sensor_msgs/Image.h>
inline bool is_valid(const sensor_msgs::Image& image) { return image.data.size() == image.step * image.height; }
//--- src/other.cpp
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include "checks.h"

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  image.height = 1;
  image.step = n;
  image.data.resize(n);
  if (is_valid(image)) pub.publish(image);
}
//--- expected
// advertise src/other.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/other.cpp:12 sensor_msgs/Image zero_copy 'image'
//
// +++ src/checks.h
// -inline bool is_valid(const sensor_msgs::Image& image) { return image.data.size() == image.step * image.height; }
// +#include <tzc/sensor_msgs/Image.h>
// +inline bool is_valid(const tzc::sensor_msgs::Image& image) { return image.data.size() == image.step * image.height; }
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// -int width_of(const sensor_msgs::Image& image) {
// +int width_of(const tzc::sensor_msgs::Image& image) {
//
// +++ src/other.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
