// --on-exhausted=drop.
//RUN: on-exhausted=drop
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish(bool twice) {
    sensor_msgs::Image image;
    image.data.resize(1);
    pub_.publish(image);
    if (twice) pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    pub_.publish(image);
// -    if (twice) pub_.publish(image);
// +    if (pub_.allocate(image)) pub_.publish(image);
// +    if (twice) { if (pub_.allocate(image)) pub_.publish(image); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
