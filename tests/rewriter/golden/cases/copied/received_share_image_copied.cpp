// A copy of the cv_bridge::CvImage shares the elements.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    cv_bridge::CvImage copy = *cv_bridge::toCvShare(image);
    cv::circle(copy.image, 1);
  }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image copied 'image' TZC2001 the cv::Mat that shares its data may be written to: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
// +  Node() { sub_ = tzc::subscribe(nh_, "image", 1, &Node::callback, this); }
