// One function takes a received message too.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

unsigned checksum(const sensor_msgs::Image& image) { return image.data[0]; }

class Node {
 public:
  Node() {
    pub_ = nh_.advertise<sensor_msgs::Image>("out", 1);
    sub_ = nh_.subscribe("in", 1, &Node::callback, this);
  }
  void callback(const sensor_msgs::Image& image) { sum_ = checksum(image); }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(10);
    image.header.seq = checksum(image);
    pub_.publish(image);
  }

 private:
  unsigned sum_ = 0;
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'out'
// subscribe src/node.cpp:11 sensor_msgs/Image shared 'in'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'callback'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>("out", 1);
// -    sub_ = nh_.subscribe("in", 1, &Node::callback, this);
// +    pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "out", 1);
// +    sub_ = tzc::subscribe(nh_, "in", 1, &Node::callback, this);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
