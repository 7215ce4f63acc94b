// Closures that fill a lasting message anew wherever they publish it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    even_pub_ = nh_.advertise<sensor_msgs::Image>("even", 1);
    odd_pub_ = nh_.advertise<sensor_msgs::Image>("odd", 1);
    loop_pub_ = nh_.advertise<sensor_msgs::Image>("loop", 1);
  }
  void in_branches(int k) {
    [&] {
      if (k % 2) {
        frame_.data.clear();
        frame_.data.push_back(k);
        odd_pub_.publish(frame_);
      } else {
        frame_.data.clear();
        frame_.data.push_back(k);
        even_pub_.publish(frame_);
      }
    }();
  }
  void in_loop(int k) {
    [&] {
      for (int i = 0; i < k; ++i) {
        if (i == 7) continue;
        other_.data.clear();
        other_.data.push_back(k);
        loop_pub_.publish(other_);
      }
    }();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher even_pub_, odd_pub_, loop_pub_;
  sensor_msgs::Image frame_, other_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'even'
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'odd'
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'loop'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'odd'
// publish src/node.cpp:21 sensor_msgs/Image zero_copy 'even'
// publish src/node.cpp:31 sensor_msgs/Image zero_copy 'loop'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    even_pub_ = nh_.advertise<sensor_msgs::Image>("even", 1);
// -    odd_pub_ = nh_.advertise<sensor_msgs::Image>("odd", 1);
// -    loop_pub_ = nh_.advertise<sensor_msgs::Image>("loop", 1);
// +    even_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "even", 1);
// +    odd_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "odd", 1);
// +    loop_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "loop", 1);
// -  ros::Publisher even_pub_, odd_pub_, loop_pub_;
// -  sensor_msgs::Image frame_, other_;
// +  tzc::Publisher even_pub_, odd_pub_, loop_pub_;
// +  tzc::sensor_msgs::Image frame_, other_;
