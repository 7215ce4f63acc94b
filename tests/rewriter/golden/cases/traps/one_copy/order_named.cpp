// A named pointer is written through, with the value of an unknown function.
#include <other/library.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void send() {
    image_.data.resize(100);
    uint8_t* first = &image_.data[0];
    first[3] = other::gamma(3, 2);
    pub_.publish(image_);
  }
  void again() { pub_.publish(image_); }
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
