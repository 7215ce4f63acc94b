// A message that starts as a copy of another one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    sensor_msgs::Image out = last_;
    out.header.seq++;
    pub_.publish(out);
  }
  void fill() { last_.data.resize(10); }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image last_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -    sensor_msgs::Image out = last_;
// +    tzc::sensor_msgs::Image out;
// +    pub_.allocate(out);
// +    out = last_;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
