// In a member of library type.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    image_.data.resize(100);
    view_ = cv::Mat(1, 1, CV_8UC3, &image_.data[0]);
    pub_.publish(image_);
  }
  void draw() { cv::flip(view_, view_, 1); }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  cv::Mat view_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'view_'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
