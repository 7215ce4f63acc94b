// A pointer into the message is used behind a call of a virtual function that does nothing; what overrides it publishes.
#include "node.h"

void Node::step() {
  image_.data.resize(100);
  uint8_t* first = &image_.data[0];
  done();
  *first = 1;
}
//--- src/sender.cpp
#include "node.h"

class Quiet : public Node {
 public:
  void done() override = 0;
};

class Sender : public Quiet {
 public:
  explicit Sender(ros::NodeHandle& nh) { pub_ = nh.advertise<sensor_msgs::Image>("image", 1); }
  void done() override { pub_.publish(image_); }

 private:
  ros::Publisher pub_;
};
//--- src/node.h
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void step();
  virtual void done() {}

 protected:
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/sender.cpp:10 sensor_msgs/Image one_copy 'image'
// publish src/sender.cpp:11 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/sender.cpp
// +#include <tzc/ros.h>
// -  explicit Sender(ros::NodeHandle& nh) { pub_ = nh.advertise<sensor_msgs::Image>("image", 1); }
// +  explicit Sender(ros::NodeHandle& nh) { pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 1); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
