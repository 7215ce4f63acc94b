// A class template that is specialised for the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class T>
struct Name {
  static int value() { return 1; }
};
template <>
struct Name<sensor_msgs::Image> {
  static int value() { return 2; }
};
template <class M>
int name(const M&) {
  return Name<M>::value();
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  image.height = name(image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:23 sensor_msgs/Image one_copy 'image' TZC1001 'name' asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
