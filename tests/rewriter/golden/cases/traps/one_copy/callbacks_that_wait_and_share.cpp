// Each callback fills a message of its own, and one that they share, and waits while others may run: what is filled by one
// callback alone is its own all the time.
#include <other/library.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    left_ = nh.advertise<sensor_msgs::Image>("left", 1);
    right_ = nh.advertise<sensor_msgs::Image>("right", 1);
    both_ = nh.advertise<sensor_msgs::Image>("both", 1);
  }
  void left(const ros::TimerEvent&) {
    left_image_.data.clear();
    shared_.data.clear();
    for (int i = 0; i < 100; ++i) {
      other::poll();
      left_image_.data.push_back(1);
      shared_.data.push_back(1);
    }
    left_.publish(left_image_);
    both_.publish(shared_);
  }
  void right(const ros::TimerEvent&) {
    right_image_.data.clear();
    shared_.data.clear();
    for (int i = 0; i < 100; ++i) {
      other::poll();
      right_image_.data.push_back(2);
      shared_.data.push_back(2);
    }
    right_.publish(right_image_);
    both_.publish(shared_);
  }

 private:
  ros::Publisher left_, right_, both_;
  sensor_msgs::Image left_image_, right_image_, shared_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'right'
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'both'
// publish src/node.cpp:22 sensor_msgs/Image zero_copy 'left'
// publish src/node.cpp:23 sensor_msgs/Image one_copy 'both' TZC1022 line 31 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:33 sensor_msgs/Image zero_copy 'right'
// publish src/node.cpp:34 sensor_msgs/Image one_copy 'both' TZC1022 line 20 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    left_ = nh.advertise<sensor_msgs::Image>("left", 1);
// -    right_ = nh.advertise<sensor_msgs::Image>("right", 1);
// -    both_ = nh.advertise<sensor_msgs::Image>("both", 1);
// +    left_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "left", 1);
// +    right_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "right", 1);
// +    both_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "both", 1);
// -  ros::Publisher left_, right_, both_;
// -  sensor_msgs::Image left_image_, right_image_, shared_;
// +  tzc::Publisher left_, right_, both_;
// +  tzc::sensor_msgs::Image left_image_, right_image_, shared_;
