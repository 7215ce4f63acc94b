// A template file that a header includes.
#include <node/node.h>
void run(ros::NodeHandle& nh) {
  Node<sensor_msgs::Image> node(nh);
  node.send();
}
//--- include/node/node.h
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
template <class M>
class Node {
 public:
  explicit Node(ros::NodeHandle& nh);
  void send();

 private:
  ros::Publisher pub_;
};
#include <node/node.tcc>
//--- include/node/node.tcc
template <class M>
Node<M>::Node(ros::NodeHandle& nh) {
  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
}
template <class M>
void Node<M>::send() {
  sensor_msgs::Image image;
  image.data.resize(100);
  pub_.publish(image);
}
//--- expected
// advertise include/node/node.tcc:3 sensor_msgs/Image zero_copy 'image'
// publish include/node/node.tcc:9 sensor_msgs/Image zero_copy 'image'
//
// +++ include/node/node.h
// +#include <tzc/ros.h>
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
//
// +++ include/node/node.tcc
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  pub_.allocate(image);
