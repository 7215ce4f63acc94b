// A closure is given a copy of a message, and another one returns one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
  void tick(unsigned n) {
    image_.data.resize(n);
    const auto send = [this](sensor_msgs::Image image) { pub_.publish(image); };
    send(image_);
  }
  void tock(unsigned n) {
    image_.data.resize(n);
    const auto get = [this]() { return image_; };
    pub_.publish(get());
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1022 it is a copy (made in line 11), whose elements lie outside shared memory until it is published
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1022 it is a copy (made in line 15), whose elements lie outside shared memory until it is published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10)) {}
// -    const auto send = [this](sensor_msgs::Image image) { pub_.publish(image); };
// +    const auto send = [this](tzc::sensor_msgs::Image image) { pub_.publish(image); };
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
