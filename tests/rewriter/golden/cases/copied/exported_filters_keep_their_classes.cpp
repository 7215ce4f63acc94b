// Other packages may use the filters of an exported class: these stay, and the calls attach their topics.
#include <node/node.h>

Node::Node(ros::NodeHandle& nh) : it_(nh) {
  image_.subscribe(it_, "image", 1);
  this->cloud_.subscribe( nh, "cloud", 1 );
  cloud_.unsubscribe();
  cloud_.subscribe();
}
void Node::again(bool both) {
  ros::NodeHandle nh;
  if (both) image_.subscribe(it_, topic_, 1);
  clouds_[0].subscribe(/* as before */ nh, "first", 1);
}
//--- include/node/node.h
#pragma once
#include <image_transport/subscriber_filter.h>
#include <message_filters/subscriber.h>
#include <sensor_msgs/PointCloud2.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh);
  void again(bool both);

 protected:
  std::string topic_;
  image_transport::ImageTransport it_;
  image_transport::SubscriberFilter image_;
  message_filters::Subscriber<sensor_msgs::PointCloud2> cloud_;
  message_filters::Subscriber<sensor_msgs::PointCloud2> clouds_[2];
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// subscribe src/node.cpp:5 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:6 sensor_msgs/PointCloud2 copied 'cloud' TZC1005 the member 'cloud_' is part of a header that other packages may include, and message_filters' own class gets a copy, since it may pass it on to a writer
// subscribe src/node.cpp:12 sensor_msgs/Image shared
// subscribe src/node.cpp:13 sensor_msgs/PointCloud2 copied 'first' TZC1005 the member 'clouds_' is part of a header that other packages may include, and message_filters' own class gets a copy, since it may pass it on to a writer
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/message_filters.h>
// -  image_.subscribe(it_, "image", 1);
// -  this->cloud_.subscribe( nh, "cloud", 1 );
// +  tzc::message_filters::subscribe(image_, it_, "image", 1);
// +  tzc::message_filters::subscribe(this->cloud_, nh, "cloud", 1 );
// -  if (both) image_.subscribe(it_, topic_, 1);
// -  clouds_[0].subscribe(/* as before */ nh, "first", 1);
// +  if (both) tzc::message_filters::subscribe(image_, it_, topic_, 1);
// +  tzc::message_filters::subscribe(clouds_[0], /* as before */ nh, "first", 1);
