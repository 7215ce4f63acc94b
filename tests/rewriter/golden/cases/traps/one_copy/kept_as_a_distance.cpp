// A pointer is kept as its distance from the object.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>


class Node {
 public:
  Node() {
    image_.data.resize(100);
    offset_ = reinterpret_cast<char*>(image_.data.data()) - reinterpret_cast<char*>(this);
  }
  void tick(const ros::TimerEvent&) {
    *(reinterpret_cast<char*>(this) + offset_) = 1;
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
  long offset_;
  ros::Timer timer_ = nh_.createTimer(ros::Duration(1), &Node::tick, this);
};
//--- expected
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data becomes a distance from something else
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
