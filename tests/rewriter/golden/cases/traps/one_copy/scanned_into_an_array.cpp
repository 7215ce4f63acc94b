// An algorithm stores pointers in a member that is an array.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <numeric>

class Node {
 public:
  Node() {
    image_.data.resize(100);
    std::exclusive_scan(steps_, steps_ + 2, rows_, image_.data.data());
  }
  void tick(const ros::TimerEvent&) {
    rows_[1][0] = 1;
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
  int steps_[2] = {10, 10};
  uint8_t* rows_[2];
  ros::Timer timer_ = nh_.createTimer(ros::Duration(1), &Node::tick, this);
};
//--- expected
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data may be stored by a call
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
