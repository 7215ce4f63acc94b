// Shared cv::Mats are kept by name and drawn on later.
#include <cv_bridge/cv_bridge.h>
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    mats_["left"] = cv_bridge::toCvShare(image)->image;
  }
  void draw() {
    for (auto& [name, mat] : mats_) cv::circle(mat, 1);
  }
  std::map<std::string, cv::Mat> mats_;

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image copied 'image' TZC2001 the cv::Mat that shares its data may be written to: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
// +  Node() { sub_ = tzc::subscribe(nh_, "image", 1, &Node::callback, this); }
