// The callback of a filter casts const away.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <message_filters/subscriber.h>

class Node {
 public:
  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    image->header.seq;
  }
  void filtered(const sensor_msgs::ImageConstPtr& image) {
    const_cast<uint8_t&>(image->data[0]) = 1;
  }
  void connect() {
    filter_.subscribe(nh_, "other", 1);
    filter_.registerCallback(&Node::filtered, this);
  }
  message_filters::Subscriber<sensor_msgs::Image> filter_;
  void last() {
  }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:18 sensor_msgs/Image copied 'other' TZC2001 const is cast away from its data: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// +#include <tzc/ros.h>
// -  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
// +  Node() { sub_ = tzc::subscribe(nh_, "image", 1, &Node::callback, this); }
// -  message_filters::Subscriber<sensor_msgs::Image> filter_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> filter_;
