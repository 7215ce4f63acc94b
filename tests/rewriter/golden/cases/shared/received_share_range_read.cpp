// The elements of a shared cv::Mat are copied out by the library.
#include <cv_bridge/cv_bridge.h>
#include <algorithm>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    cv::Mat mat = cv_bridge::toCvShare(image)->image;
    std::vector<unsigned char> all(mat.data, mat.data + mat.total());
    all.assign(mat.data, mat.data + mat.total());
    std::copy(mat.data, mat.data + mat.total(), all.begin());
  }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
// +  Node() { sub_ = tzc::subscribe(nh_, "image", 1, &Node::callback, this); }
