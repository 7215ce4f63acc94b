// A function is given the member that it fills by its own name; what it returns is a copy of elements that nobody shares yet.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh)
      : pub_(nh.advertise<sensor_msgs::Image>("image", 10)), other_pub_(nh.advertise<sensor_msgs::Image>("other", 10)) {}
  void tick(unsigned n) {
    pub_.publish(image_);
    size_ = n;
    pub_.publish(filled(image_));
  }
  void tock() {
    other_pub_.publish(other_);
    other_pub_.publish(passed_on(other_));
  }

 private:
  sensor_msgs::Image filled(const sensor_msgs::Image& in) {
    image_.data.resize(size_);
    return in;
  }
  sensor_msgs::Image passed_on(const sensor_msgs::Image& in) { return filled_other(in); }
  sensor_msgs::Image filled_other(const sensor_msgs::Image& in) {
    other_.data.resize(size_);
    return in;
  }

  ros::Publisher pub_, other_pub_;
  sensor_msgs::Image image_, other_;
  unsigned size_ = 0;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'other'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1022 line 21 may give it more elements after this publish, which copies those that it has
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1022 it is a copy (made in line 22), whose elements lie outside shared memory until it is published
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'other' TZC1022 line 26 may give it more elements after this publish, which copies those that it has
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'other' TZC1022 it is a copy (made in line 27), whose elements lie outside shared memory until it is published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -      : pub_(nh.advertise<sensor_msgs::Image>("image", 10)), other_pub_(nh.advertise<sensor_msgs::Image>("other", 10)) {}
// +      : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10)), other_pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "other", 10)) {}
// -  sensor_msgs::Image filled(const sensor_msgs::Image& in) {
// +  tzc::sensor_msgs::Image filled(const tzc::sensor_msgs::Image& in) {
// -  sensor_msgs::Image passed_on(const sensor_msgs::Image& in) { return filled_other(in); }
// -  sensor_msgs::Image filled_other(const sensor_msgs::Image& in) {
// +  tzc::sensor_msgs::Image passed_on(const tzc::sensor_msgs::Image& in) { return filled_other(in); }
// +  tzc::sensor_msgs::Image filled_other(const tzc::sensor_msgs::Image& in) {
// -  ros::Publisher pub_, other_pub_;
// -  sensor_msgs::Image image_, other_;
// +  tzc::Publisher pub_, other_pub_;
// +  tzc::sensor_msgs::Image image_, other_;
