// Its elements are published under another name.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) { pub_ = nh.advertise<sensor_msgs::Image>("image", 1); }
  void tick() {
    filter();
    pub_.publish(image_);
  }
  static void fill(sensor_msgs::Image& image) { image.data.resize(100); }

 private:
  void filter();
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

void make(sensor_msgs::Image& to) {
  sensor_msgs::Image image;
  Node::fill(image);
  to.data.swap(image.data);
}
void Node::filter() { make(image_); }
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1019 it is built where its publisher cannot be named: 'pub_' is a member of another object
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Node(ros::NodeHandle& nh) { pub_ = nh.advertise<sensor_msgs::Image>("image", 1); }
// +  explicit Node(ros::NodeHandle& nh) { pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 1); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
