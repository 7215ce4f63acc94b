// The unit that holds a pointer into the data does not show the deleter that publishes: another unit makes it.
#include "node.h"

void Node::publish() {
  image_.data.resize(100);
  uint8_t* first = &image_.data[0];
  guard_.reset();
  *first = 1;
}
//--- src/node.h
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <memory>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void arm();
  void send() { pub_.publish(image_); }
  void publish();

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  std::shared_ptr<int> guard_;
};
//--- src/arm.cpp
#include "node.h"

void Node::arm() {
  guard_ = std::shared_ptr<int>(new int(0), [this](int* number) {
    send();
    delete number;
  });
}
//--- expected
// advertise src/node.h:7 sensor_msgs/Image one_copy 'image'
// publish src/node.h:9 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.h
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
