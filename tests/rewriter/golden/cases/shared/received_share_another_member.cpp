// Another image of the class is drawn on.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    mat_ = cv_bridge::toCvShare(image)->image;
  }
  void draw() { cv::circle(canvas_, 1); }
  cv::Mat mat_, canvas_;

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
// +  Node() { sub_ = tzc::subscribe(nh_, "image", 1, &Node::callback, this); }
