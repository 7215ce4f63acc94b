// A package whose publishers were ported before (--level=one_copy): its messages follow.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1, 0); }
  void send() {
    sensor_msgs::Image image;
    image.data.resize(10);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  tzc::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
