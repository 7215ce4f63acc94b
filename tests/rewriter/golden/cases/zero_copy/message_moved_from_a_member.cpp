// A message that takes over a member's elements is no copy.
#include <utility>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
  void fill() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    pending_ = std::move(image);
  }
  void send() {
    sensor_msgs::Image out = std::move(pending_);
    pub_.publish(out);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image pending_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image out = std::move(pending_);
// +    tzc::sensor_msgs::Image out = std::move(pending_);
// -  ros::Publisher pub_;
// -  sensor_msgs::Image pending_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image pending_;
