// What converts to a message is no message that a ported one can be assigned; the copy has content all the same.
#include <functional>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame : sensor_msgs::Image {
  int camera = 0;
};

class Node {
 public:
  void derived() {
    Frame frame;
    frame.data.resize(9000);
    sensor_msgs::Image out(frame);
    pub_.publish(out);
  }
  void converted(const sensor_msgs::Image& in) {
    sensor_msgs::Image out(std::cref(in));
    pub_.publish(out);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1013 it starts as 'out(frame)', which code outside the package builds
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'image' TZC1020 it starts as a copy of another message
// advertise src/node.cpp:26 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
