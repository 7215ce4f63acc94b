//RUN: flags=-DDECLARED_FIRST
// A unit sees the message declared before it is defined, and keeps a pointer to its elements.
#include "node.h"

#include <sensor_msgs/Image.h>

void Node::make(int n) {
  image_.reset(new sensor_msgs::Image);
  image_->data.resize(n);
  pub_.publish(image_);
}
//--- src/node.h
#pragma once
#include <ros/ros.h>
namespace sensor_msgs {
template <class A>
struct Image_;
typedef Image_<std::allocator<void>> Image;
typedef boost::shared_ptr<Image> ImagePtr;
}  // namespace sensor_msgs
void advertise(ros::NodeHandle& nh, ros::Publisher& pub);
class Node {
 public:
  void make(int n);
  void keep();
  void change() { pixels_[0] = 1; }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::ImagePtr image_;
  uint8_t* pixels_;
};
//--- src/advertise.cpp
#include <sensor_msgs/Image.h>

#include "node.h"
void advertise(ros::NodeHandle& nh, ros::Publisher& pub) {
  pub = nh.advertise<sensor_msgs::Image>("image", 10);
}
//--- src/keep.cpp
#include "node.h"
#include <sensor_msgs/Image.h>
void Node::keep() {
  advertise(nh_, pub_);
  pixels_ = &image_->data[0];
}
//--- expected
// advertise src/advertise.cpp:5 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'pixels_'
//
// +++ src/advertise.cpp
// +#include <tzc/ros.h>
// -void advertise(ros::NodeHandle& nh, ros::Publisher& pub) {
// -  pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +void advertise(ros::NodeHandle& nh, tzc::Publisher& pub) {
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
//
// +++ src/node.h
// +#include <tzc/ros.h>
// -void advertise(ros::NodeHandle& nh, ros::Publisher& pub);
// +void advertise(ros::NodeHandle& nh, tzc::Publisher& pub);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
