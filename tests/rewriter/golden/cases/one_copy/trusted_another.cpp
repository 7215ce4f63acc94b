// Another function is trusted, not this one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

namespace camera {
void read_frame(uint8_t* to);
}

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void send() {
    image_.data.resize(100);
    camera::read_frame(&image_.data[0]);
    pub_.publish(image_);
  }
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- .tzc-rewrite.yaml
keeps_nothing:
  - function: camera::read
    reason: it copies the frame and returns
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'camera::read_frame'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
