// The callback is a function object of the package.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Draw {
  void operator()(const sensor_msgs::ImageConstPtr& image) const {
    cv::Mat mat = cv_bridge::toCvShare(image)->image;
    cv::circle(mat, 1);
  }
};

class Node {
 public:
  Node() { sub_ = nh_.subscribe<sensor_msgs::Image>("image", 1, Draw()); }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:15 sensor_msgs/Image copied 'image' TZC2001 the cv::Mat that shares its data may be written to: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { sub_ = nh_.subscribe<sensor_msgs::Image>("image", 1, Draw()); }
// +  Node() { sub_ = tzc::subscribe<sensor_msgs::Image>(nh_, "image", 1, Draw()); }
