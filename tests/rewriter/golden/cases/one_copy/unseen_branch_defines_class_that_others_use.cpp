// The class is defined for two versions of ROS, and code that is compiled with either of them calls it: changed for one of them, it
// would not fit the other.
#ifndef SIMULATED
#define REAL
#endif
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

static ros::Publisher pub;

#ifdef REAL
struct Output {
  void send(sensor_msgs::Image& image) { pub.publish(image); }
};
#endif
#ifdef SIMULATED
struct Output {
  void send(sensor_msgs::Image& image) { image.data.clear(); }
};
#endif

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("image", 1);
  Output output;
  sensor_msgs::Image image;
  image.data.resize(100);
  output.send(image);
}
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC3007 a preprocessor branch that is not compiled here names 'send'
// advertise src/node.cpp:25 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -static ros::Publisher pub;
// +static tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
