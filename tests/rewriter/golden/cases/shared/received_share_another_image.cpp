// Another cv_bridge::CvImage is drawn on, and the header of this one is written.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    cv_bridge::CvImage mine;
    mine.image = cv_bridge::toCvShare(image)->image;
    mine.header.frame_id = "camera";
    cv_bridge::CvImagePtr copy = cv_bridge::toCvCopy(image);
    cv::circle(copy->image, 1);
  }

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
