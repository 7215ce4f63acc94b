// Two filters of one class: the callback of one of them takes the message as its own.
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : reading_(nh, "read", 1), drawing_(nh, "drawn", 1) {
    reading_.registerCallback(&Node::look, this);
    drawing_.registerCallback(&Node::draw, this);
  }
  void look(const sensor_msgs::ImageConstPtr&) {}
  void draw(const sensor_msgs::ImagePtr&) {}

 private:
  message_filters::Subscriber<sensor_msgs::Image> reading_, drawing_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'read'
// subscribe src/node.cpp:8 sensor_msgs/Image copied 'drawn' TZC2001 the callback may write to the message, so it gets a copy of its own
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  message_filters::Subscriber<sensor_msgs::Image> reading_, drawing_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> reading_, drawing_;
