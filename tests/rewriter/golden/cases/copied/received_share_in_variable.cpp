// The callback is kept in a variable first.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    const auto callback = [](const sensor_msgs::ImageConstPtr& image) {
      cv::Mat mat = cv_bridge::toCvShare(image)->image;
      cv::circle(mat, 1);
    };
    sub_ = nh_.subscribe<sensor_msgs::Image>("image", 1, callback);
  }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:13 sensor_msgs/Image copied 'image' TZC2001 the cv::Mat that shares its data may be written to: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    sub_ = nh_.subscribe<sensor_msgs::Image>("image", 1, callback);
// +    sub_ = tzc::subscribe<sensor_msgs::Image>(nh_, "image", 1, callback);
