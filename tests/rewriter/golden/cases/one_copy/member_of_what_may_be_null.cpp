// No place in front of the first use is one at which the pointer leads somewhere.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  sensor_msgs::Image image;
};

class Node {
 public:
  void send(Frame* frame) {
    if (frame && frame->image.data.empty()) return;
    ++count_;
    if (frame) pub_.publish(frame->image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1019 the expression that names it means something else, or nothing, where allocate would stand
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
