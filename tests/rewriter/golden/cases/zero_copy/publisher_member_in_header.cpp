// The publisher is a member that a header declares.
#include "node.h"

void Node::publish() {
  sensor_msgs::Image image;
  image.data.resize(10);
  pub_.publish(image);
}

Node::Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
//--- include/node.h
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node();
  void publish();

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- src/main.cpp
#include "node.h"

int main() {
  Node node;
  node.publish();
}
//--- expected
// publish src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
//
// +++ include/node.h
// +#include <tzc/ros.h>
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  pub_.allocate(image);
// -Node::Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
// +Node::Node() : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)) {}
