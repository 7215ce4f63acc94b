// Const is cast away from a message of the node's own: what callbacks receive stays shared.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : subscriber_(nh.subscribe("image", 1, &Node::onImage, this)) {
    fill(own_);
  }

 private:
  void onImage(const sensor_msgs::ImageConstPtr& image) { ROS_INFO("%zu bytes", image->data.size()); }
  static void fill(const sensor_msgs::Image& image) {
    const_cast<sensor_msgs::Image&>(image).data.push_back(1);
  }
  ros::Subscriber subscriber_;
  sensor_msgs::Image own_;
};
//--- expected
// subscribe src/node.cpp:7 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Node(ros::NodeHandle& nh) : subscriber_(nh.subscribe("image", 1, &Node::onImage, this)) {
// +  explicit Node(ros::NodeHandle& nh) : subscriber_(tzc::subscribe(nh, "image", 1, &Node::onImage, this)) {
