// A filter whose callback may write.
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() : image_(nh_, "image", 1) { image_.registerCallback(&Node::callback, this); }
  void callback(const sensor_msgs::ImagePtr& image) {}

 private:
  ros::NodeHandle nh_;
  message_filters::Subscriber<sensor_msgs::Image> image_;
};
//--- expected
// subscribe src/node.cpp:7 sensor_msgs/Image copied 'image' TZC2001 the callback may write to the message, so it gets a copy of its own
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  message_filters::Subscriber<sensor_msgs::Image> image_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> image_;
