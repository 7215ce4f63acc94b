// The override that publishes is in another unit than the one that calls the base class.
#include "node.h"

void Node::publish() {
  image_.data.resize(100);
  uint8_t* first = &image_.data[0];
  console_->sputc('a');
  *first = 1;
}
//--- src/node.h
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <memory>
#include <streambuf>

class Node {
 public:
  Node();
  void send() { pub_.publish(image_); }
  void publish();

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  std::streambuf* console_;
};
//--- src/console.cpp
#include "node.h"

class Console : public std::streambuf {
 public:
  explicit Console(Node& node) : node_(node) {}

 protected:
  int overflow(int c) override {
    node_.send();
    return c;
  }

 private:
  Node& node_;
};

Node::Node() : console_(new Console(*this)) {
  pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
}
//--- expected
// advertise src/console.cpp:18 sensor_msgs/Image one_copy 'image'
// publish src/node.h:9 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/console.cpp
// +#include <tzc/ros.h>
// -  pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// +  pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10);
//
// +++ src/node.h
// +#include <tzc/ros.h>
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
