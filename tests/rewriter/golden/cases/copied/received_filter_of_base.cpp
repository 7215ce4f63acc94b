// A filter of a base class, whose callback is registered by another class.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <message_filters/subscriber.h>

class Base {
 protected:
  void connect() { filter_.subscribe(nh_, "image", 1); }
  ros::NodeHandle nh_;
  message_filters::Subscriber<sensor_msgs::Image> filter_;
};

class Node : public Base {
 public:
  Node() {
    filter_.registerCallback(&Node::callback, this);
    connect();
  }
  void callback(const sensor_msgs::ImageConstPtr& image) { const_cast<uint8_t&>(image->data[0]) = 1; }
};
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image copied 'image' TZC2001 const is cast away from its data: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  message_filters::Subscriber<sensor_msgs::Image> filter_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> filter_;
