// A function is given a message that has been published, and writes it by its own name.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
  void tick() {
    pub_.publish(image_);
    mark(image_);
  }

 private:
  void mark(const sensor_msgs::Image& in) {
    if (!in.data.empty()) image_.data[0] = 255;
  }

  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image one_copy 'image' TZC1022 line 15 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10)) {}
// -  void mark(const sensor_msgs::Image& in) {
// +  void mark(const tzc::sensor_msgs::Image& in) {
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
