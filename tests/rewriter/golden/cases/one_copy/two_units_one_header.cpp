// A header of two units: the component spans both; one refusal stops the whole.
#include <ros/ros.h>

#include "fill.h"

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  fill(image);
  pub.publish(image);
}
//--- include/fill.h
#pragma once
#include <sensor_msgs/Image.h>
void fill(sensor_msgs::Image& image);
//--- src/fill.cpp
#include "fill.h"
#include <other/library.h>

void fill(sensor_msgs::Image& image) { other::rotate(image); }
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1002 it is passed to 'other::rotate', which is not part of the package
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
