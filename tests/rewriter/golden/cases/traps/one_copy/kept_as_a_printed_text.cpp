// A pointer is printed into a buffer, and read again.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cstdio>

class Node {
 public:
  Node() {
    image_.data.resize(100);
    snprintf(text_, sizeof text_, "%p", image_.data.data());
  }
  void tick(const ros::TimerEvent&) {
    void* pixels;
    sscanf(text_, "%p", &pixels);
    *static_cast<uint8_t*>(pixels) = 1;
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
  char text_[40];
  ros::Timer timer_ = nh_.createTimer(ros::Duration(1), &Node::tick, this);
};
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is written down as a text
// advertise src/node.cpp:22 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
