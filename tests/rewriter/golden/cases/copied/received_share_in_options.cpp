// The callback is part of options.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    ros::SubscribeOptions options;
    options.init<sensor_msgs::Image>("image", 1, boost::bind(&Node::callback, this, _1));
    sub_ = nh_.subscribe(options);
  }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    cv::Mat mat = cv_bridge::toCvShare(image)->image;
    cv::circle(mat, 1);
  }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:11 sensor_msgs/Image copied TZC2001 the cv::Mat that shares its data may be written to: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    sub_ = nh_.subscribe(options);
// +    sub_ = tzc::subscribe<sensor_msgs::Image>(nh_, options);
