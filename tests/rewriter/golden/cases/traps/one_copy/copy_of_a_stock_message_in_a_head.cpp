// Nothing publishes the message that is copied, so it stays a stock one, and no ported message can start as a copy of it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void keep(int count) { last_.data.assign(count, 1); }
  void send() {
    if (sensor_msgs::Image out = last_; !out.data.empty()) pub_.publish(out);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image last_;
};
//--- expected
// publish src/node.cpp:9 sensor_msgs/Image one_copy 'image' TZC1020 it starts as a copy of another message
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
