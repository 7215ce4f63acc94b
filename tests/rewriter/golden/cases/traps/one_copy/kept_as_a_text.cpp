// A pointer is written down, and read again.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <sstream>

class Node {
 public:
  Node() {
    image_.data.resize(100);
    std::ostringstream text;
    text << static_cast<const void*>(image_.data.data());
    text_ = text.str();
  }
  void tick(const ros::TimerEvent&) {
    void* pixels;
    std::istringstream(text_) >> pixels;
    *static_cast<uint8_t*>(pixels) = 1;
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
  std::string text_;
  ros::Timer timer_ = nh_.createTimer(ros::Duration(1), &Node::tick, this);
};
//--- expected
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is written down as a text
// advertise src/node.cpp:24 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
