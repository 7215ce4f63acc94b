// An address that was a number meanwhile.
#include <cstdint>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(image->data.data());
    *reinterpret_cast<uint8_t*>(address + 1) = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image copied 'image' TZC2001 const is cast away from its data: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
// +  Node() { sub_ = tzc::subscribe(nh_, "image", 1, &Node::callback, this); }
