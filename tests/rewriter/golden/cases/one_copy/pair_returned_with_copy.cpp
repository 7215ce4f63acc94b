// A function returns a copy of a message, its own or its caller's, in a pair, which a structured binding takes apart.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <utility>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
  void tick(unsigned n) {
    image_.data.resize(n);
    auto [image, number] = both();
    pub_.publish(image);
  }
  void tock(unsigned n) {
    sensor_msgs::Image frame;
    frame.data.resize(n);
    auto [image, number] = beside(frame);
    pub_.publish(image);
  }

 private:
  std::pair<sensor_msgs::Image, int> both() { return {image_, 1}; }
  std::pair<sensor_msgs::Image, int> beside(const sensor_msgs::Image& image) { return {image, 1}; }

  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1022 its elements come from a message that is never published itself (returned from 'both' in line 22), and lie outside shared memory
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1022 it is a copy (returned from 'beside' in line 23), whose elements lie outside shared memory until it is published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10)) {}
// -    sensor_msgs::Image frame;
// +    tzc::sensor_msgs::Image frame;
// +    pub_.allocate(frame);
// -  std::pair<sensor_msgs::Image, int> both() { return {image_, 1}; }
// -  std::pair<sensor_msgs::Image, int> beside(const sensor_msgs::Image& image) { return {image, 1}; }
// +  std::pair<tzc::sensor_msgs::Image, int> both() { return {image_, 1}; }
// +  std::pair<tzc::sensor_msgs::Image, int> beside(const tzc::sensor_msgs::Image& image) { return {image, 1}; }
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
