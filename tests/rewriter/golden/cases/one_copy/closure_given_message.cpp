// A closure fills what it is given: messages that last cost a copy, new ones do not.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <vector>

class Node {
 public:
  Node() : frames_(2) {
    direct_pub_ = nh_.advertise<sensor_msgs::Image>("direct", 1);
    each_pub_ = nh_.advertise<sensor_msgs::Image>("each", 1);
    sender_pub_ = nh_.advertise<sensor_msgs::Image>("sender", 1);
    left_pub_ = nh_.advertise<sensor_msgs::Image>("left", 1);
    right_pub_ = nh_.advertise<sensor_msgs::Image>("right", 1);
    last_.data.resize(100);
    sent_.data.resize(100);
  }
  void direct() {
    const auto fill = [this](sensor_msgs::Image& image) { image.data[0] = n_++; };
    fill(last_);
    direct_pub_.publish(last_);
  }
  void each() {
    for (sensor_msgs::Image& frame : frames_) frame.data.resize(100);
    std::for_each(frames_.begin(), frames_.end(), [this](sensor_msgs::Image& image) { image.data[0] = n_++; });
    each_pub_.publish(frames_[0]);
  }
  void sender() {
    sent_.data[0] = n_++;
    [this](const sensor_msgs::Image& image) { sender_pub_.publish(image); }(sent_);
  }
  void both() {
    sensor_msgs::Image left, right;
    const auto fill = [this](sensor_msgs::Image& image) {
      image.data.resize(100);
      for (int i = 0; i < 100; ++i) image.data[i] = n_;
    };
    fill(left);
    left_pub_.publish(left);
    fill(right);
    right_pub_.publish(right);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher direct_pub_, each_pub_, sender_pub_, left_pub_, right_pub_;
  std::vector<sensor_msgs::Image> frames_;
  sensor_msgs::Image last_, sent_;
  int n_ = 0;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'direct'
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'each'
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'sender'
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'right'
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'direct' TZC1022 line 20 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:27 sensor_msgs/Image one_copy 'each' TZC1002 it is passed to 'std::for_each', which is not part of the package
// publish src/node.cpp:31 sensor_msgs/Image one_copy 'sender' TZC1005 it is a parameter of 'lambda', which other code calls
// publish src/node.cpp:40 sensor_msgs/Image zero_copy 'left'
// publish src/node.cpp:42 sensor_msgs/Image zero_copy 'right'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    direct_pub_ = nh_.advertise<sensor_msgs::Image>("direct", 1);
// -    each_pub_ = nh_.advertise<sensor_msgs::Image>("each", 1);
// -    sender_pub_ = nh_.advertise<sensor_msgs::Image>("sender", 1);
// -    left_pub_ = nh_.advertise<sensor_msgs::Image>("left", 1);
// -    right_pub_ = nh_.advertise<sensor_msgs::Image>("right", 1);
// +    direct_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "direct", 1);
// +    each_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "each", 1);
// +    sender_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "sender", 1);
// +    left_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "left", 1);
// +    right_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "right", 1);
// -    const auto fill = [this](sensor_msgs::Image& image) { image.data[0] = n_++; };
// +    const auto fill = [this](tzc::sensor_msgs::Image& image) { image.data[0] = n_++; };
// -    sensor_msgs::Image left, right;
// -    const auto fill = [this](sensor_msgs::Image& image) {
// -      image.data.resize(100);
// +    tzc::sensor_msgs::Image left, right;
// +    left_pub_.allocate(left);
// +    right_pub_.allocate(right);
// +    const auto fill = [this](tzc::sensor_msgs::Image& image) {
// +      image.data.resize(100, tzc::uninitialized);
// -  ros::Publisher direct_pub_, each_pub_, sender_pub_, left_pub_, right_pub_;
// +  tzc::Publisher direct_pub_, each_pub_, sender_pub_, left_pub_, right_pub_;
// -  sensor_msgs::Image last_, sent_;
// +  tzc::sensor_msgs::Image last_;
// +  sensor_msgs::Image sent_;
