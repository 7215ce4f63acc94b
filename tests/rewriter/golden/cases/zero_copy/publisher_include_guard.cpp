// Includes go behind the stock header, in a header with an include guard.
#include "node.h"

void Node::publish() {}
//--- include/node.h
// A node.
#ifndef NODE_H
#define NODE_H

#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#ifdef HAVE_SOMETHING
#include <vector>
#endif

class Node {
 public:
  void publish();
  void run() {
    pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
    sensor_msgs::Image image;
    image.data.resize(1);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};

#endif
//--- expected
// advertise include/node.h:15 sensor_msgs/Image zero_copy 'image'
// publish include/node.h:18 sensor_msgs/Image zero_copy 'image'
//
// +++ include/node.h
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -    sensor_msgs::Image image;
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
