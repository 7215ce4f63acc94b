// A cast away from const for a field beside the array: that part of the view is private.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    sub_ = nh_.subscribe("image", 1, &Node::callback, this);
    other_ = nh_.subscribe("image", 1, &Node::by_reference, this);
  }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    boost::const_pointer_cast<sensor_msgs::Image>(image)->encoding = "mono8";
  }
  void by_reference(const sensor_msgs::Image& image) { const_cast<sensor_msgs::Image&>(image).width = 1; }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_, other_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    sub_ = nh_.subscribe("image", 1, &Node::callback, this);
// -    other_ = nh_.subscribe("image", 1, &Node::by_reference, this);
// +    sub_ = tzc::subscribe(nh_, "image", 1, &Node::callback, this);
// +    other_ = tzc::subscribe(nh_, "image", 1, &Node::by_reference, this);
