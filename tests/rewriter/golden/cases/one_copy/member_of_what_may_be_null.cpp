// A parameter: the object that it leads to may be new each time, or not be there at all.
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
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1022 'frame' may be another object each time, with content outside shared memory
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
