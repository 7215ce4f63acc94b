// Closures that publish in one of two branches, or leave early, and write afterwards; and one object that two publishers share.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    even_pub_ = nh_.advertise<sensor_msgs::Image>("even", 1);
    odd_pub_ = nh_.advertise<sensor_msgs::Image>("odd", 1);
    early_pub_ = nh_.advertise<sensor_msgs::Image>("early", 1);
    one_pub_ = nh_.advertise<sensor_msgs::Image>("one", 1);
    other_pub_ = nh_.advertise<sensor_msgs::Image>("other", 1);
  }
  void in_branches(int k) {
    [&] {
      if (k % 2)
        odd_pub_.publish(frame_);
      else
        even_pub_.publish(frame_);
      frame_.data[0] = k;
    }();
  }
  void left_early(int k) {
    [&] {
      early_.data[0] = k;
      early_pub_.publish(early_);
      if (k % 2) return;
      early_.data.clear();
      early_.data.resize(100);
    }();
  }
  void by_two(int k) {
    both_.data[0] = k;
    one_pub_.publish(both_);
    other_pub_.publish(both_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher even_pub_, odd_pub_, early_pub_, one_pub_, other_pub_;
  sensor_msgs::Image frame_, early_, both_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'even'
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'odd'
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'early'
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'one'
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'other'
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'odd' TZC1022 line 20 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'even' TZC1022 line 20 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:26 sensor_msgs/Image one_copy 'early' TZC1022 line 25 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:34 sensor_msgs/Image one_copy 'one' TZC1022 line 33 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:35 sensor_msgs/Image one_copy 'other' TZC1022 line 33 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    even_pub_ = nh_.advertise<sensor_msgs::Image>("even", 1);
// -    odd_pub_ = nh_.advertise<sensor_msgs::Image>("odd", 1);
// -    early_pub_ = nh_.advertise<sensor_msgs::Image>("early", 1);
// -    one_pub_ = nh_.advertise<sensor_msgs::Image>("one", 1);
// -    other_pub_ = nh_.advertise<sensor_msgs::Image>("other", 1);
// +    even_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "even", 1);
// +    odd_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "odd", 1);
// +    early_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "early", 1);
// +    one_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "one", 1);
// +    other_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "other", 1);
// -  ros::Publisher even_pub_, odd_pub_, early_pub_, one_pub_, other_pub_;
// -  sensor_msgs::Image frame_, early_, both_;
// +  tzc::Publisher even_pub_, odd_pub_, early_pub_, one_pub_, other_pub_;
// +  tzc::sensor_msgs::Image frame_, early_, both_;
