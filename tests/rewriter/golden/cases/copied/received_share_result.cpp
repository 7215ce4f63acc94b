// A function of the package returns the shared image.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

cv_bridge::CvImageConstPtr view(const sensor_msgs::ImageConstPtr& image) { return cv_bridge::toCvShare(image); }

class Node {
 public:
  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    cv::Mat mat = view(image)->image;
    cv::circle(mat, 1);
  }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/Image copied 'image' TZC2001 the cv::Mat that shares its data may be written to: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
// +  Node() { sub_ = tzc::subscribe(nh_, "image", 1, &Node::callback, this); }
