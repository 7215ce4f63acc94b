// What is called after the publish may throw, and the handler marks the message that subscribers share.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <stdexcept>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}

  void tick(unsigned n) {
    try {
      pub_.publish(image_);
      check(n);
    } catch (const std::runtime_error&) {
      image_.data.back() = 255;
    }
  }

 private:
  static void check(unsigned n) {
    if (n == 0) throw std::runtime_error("no pixels");
  }

  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1022 line 15 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
