// A member's constructor calls a function that asks before it publishes: allocate would not.
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
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1019 it is built where its publisher cannot be named
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -      : warm_up_(*this), pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {
// +      : warm_up_(*this), pub_(tzc::advertise<sensor_msgs::Image>(nh, "image", 1)) {
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
