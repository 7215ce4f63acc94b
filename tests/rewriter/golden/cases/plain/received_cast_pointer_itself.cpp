// A C cast of the smart pointer.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    sensor_msgs::ImagePtr& mine = (sensor_msgs::ImagePtr&)image;
    mine->data[0] = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it
