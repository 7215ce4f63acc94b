// A received message is copied, changed and published: one copy.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    pub_ = nh_.advertise<sensor_msgs::Image>("out", 1);
    sub_ = nh_.subscribe("in", 1, &Node::callback, this);
  }
  void callback(const sensor_msgs::Image& image) {
    sensor_msgs::Image out = image;
    out.header.frame_id = "out";
    pub_.publish(out);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'out'
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'in'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'out'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>("out", 1);
// -    sub_ = nh_.subscribe("in", 1, &Node::callback, this);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "out", 1);
// +    sub_ = tzc::subscribe(nh_, "in", 1, &Node::callback, this);
// -    sensor_msgs::Image out = image;
// +    tzc::sensor_msgs::Image out;
// +    pub_.allocate(out);
// +    out = image;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
