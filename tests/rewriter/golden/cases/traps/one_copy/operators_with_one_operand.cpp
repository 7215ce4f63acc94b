// What is assigned has an operator of the package's own, with one operand: it is no step to another element.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Offset {
  double x;
  Offset operator-() const { return Offset{-x}; }
  Offset operator+() const { return *this; }
};
struct Frame {
  sensor_msgs::Image image;
  Frame operator-() const { return *this; }
};

void send(ros::NodeHandle& nh, const Offset& from, const Frame& last) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  Offset to{0};
  to = -from;
  to = +to;
  Frame frame;
  frame = -last;
  frame.image.data.assign(100, static_cast<unsigned char>(to.x));
  pub.publish(frame.image);
}
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:23 sensor_msgs/Image one_copy 'image' TZC1019 the expression that names it means something else, or nothing, where allocate would stand
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
