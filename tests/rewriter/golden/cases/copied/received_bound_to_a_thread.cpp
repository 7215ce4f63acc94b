// The message is bound to a thread, which draws on it.
#include <thread>

#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) { sub_ = nh.subscribe("image", 1, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) { std::thread(&Node::work, this, image).detach(); }
  void work(const sensor_msgs::ImageConstPtr& image) {
    cv::Mat mat = cv_bridge::toCvShare(image)->image;
    mat.at<uint8_t>(0, 0) = 1;
  }

 private:
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/Image copied 'image' TZC2001 the cv::Mat that shares its data may be written to: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Node(ros::NodeHandle& nh) { sub_ = nh.subscribe("image", 1, &Node::callback, this); }
// +  explicit Node(ros::NodeHandle& nh) { sub_ = tzc::subscribe(nh, "image", 1, &Node::callback, this); }
