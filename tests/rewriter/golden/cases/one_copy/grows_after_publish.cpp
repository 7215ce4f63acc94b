// A lasting message that is given another number of elements each time, and none of them a value.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
  void send(int k) {
    frame_.data.resize(16 + k);
    pub_.publish(frame_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image frame_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1022 line 9 may give it more elements after this publish, which copies those that it has
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1); }
// -  ros::Publisher pub_;
// -  sensor_msgs::Image frame_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image frame_;
