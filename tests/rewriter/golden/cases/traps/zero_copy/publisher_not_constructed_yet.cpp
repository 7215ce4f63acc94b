// A member's constructor calls a function that asks before it publishes: nothing else may look at the publisher, which is
// not constructed yet.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node;
struct WarmUp {
  explicit WarmUp(Node& node);
};

class Node {
 public:
  explicit Node(ros::NodeHandle& nh)
      : warm_up_(*this), pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {
    running_ = true;
  }
  void step() {
    image_.data.assign(64, 1);
    if (running_) pub_.publish(image_);
  }

 private:
  bool running_ = false;
  sensor_msgs::Image image_;
  WarmUp warm_up_;
  ros::Publisher pub_;
};

WarmUp::WarmUp(Node& node) { node.step(); }
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -      : warm_up_(*this), pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {
// +      : warm_up_(*this), pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1)) {
// -  sensor_msgs::Image image_;
// +  tzc::sensor_msgs::Image image_;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
