// --only a topic: its advertise and publish sites, and nothing else.
//RUN: only=a
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    a_ = nh_.advertise<sensor_msgs::Image>("a", 1);
    b_ = nh_.advertise<sensor_msgs::Image>("b", 1);
  }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(1);
    a_.publish(image);
    sensor_msgs::Image other;
    other.data.resize(1);
    b_.publish(other);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher a_;
  ros::Publisher b_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'a'
// advertise src/node.cpp:10 sensor_msgs/Image plain 'b' TZC1016 left out by --only or --except
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'a'
// publish src/node.cpp:18 sensor_msgs/Image plain 'b' TZC1016 left out by --only or --except
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    a_ = nh_.advertise<sensor_msgs::Image>("a", 1);
// +    a_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "a", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    a_.allocate(image);
// -  ros::Publisher a_;
// +  tzc::Publisher a_;
