// A header that no unit includes is reported when it seems to hold sites; a unit may include a source.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include "used.hpp"
#include "part.cc"

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//--- src/used.hpp
template <class P, class M>
void send(P& publisher, const M& message) {
  publisher.publish(message);
}
//--- src/part.cc
inline void part() {}
//--- include/unused.hpp
template <class P, class M>
void send_all(P& publisher, const M& message) {
  publisher.publish(message);
}
//--- include/bodies.tcc
// publish(message) as documentation names it
template <class N>
void make(N& node) {
  node.template advertise<int>("topic", 1);
  node.subscribe("topic", 1, nullptr);
}
//--- include/idle.h
/**
 * publish() is named here alone
 */
struct Idle {};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// note include/bodies.tcc:1 TZC3001
// note include/unused.hpp:1 TZC3001
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
