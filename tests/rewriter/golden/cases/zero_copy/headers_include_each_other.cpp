// Each unit reads node.h twice, the second time while the first one is not over: its guard skips it all then.
#include "node.h"

void Node::step() {
  sensor_msgs::Image image;
  image.data.resize(size());
  pub_.publish(image);
}
//--- src/node.h
#ifndef NODE_H
#define NODE_H
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include "size.h"

class Node : Size {
 public:
  explicit Node(ros::NodeHandle& nh) { pub_ = nh.advertise<sensor_msgs::Image>("image", 10); }
  void step();

 private:
  ros::Publisher pub_;
};
#endif
//--- src/size.h
#ifndef SIZE_H
#define SIZE_H
#include "node.h"

struct Size {
  int size() const { return 10; }
};
#endif
//--- expected
// publish src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// advertise src/node.h:9 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  pub_.allocate(image);
//
// +++ src/node.h
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) { pub_ = nh.advertise<sensor_msgs::Image>("image", 10); }
// +  explicit Node(ros::NodeHandle& nh) { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
