// A member of an object of a class template that is specialised for the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class M>
struct Defaults {
  int step = 0;
};
template <>
struct Defaults<sensor_msgs::Image> {
  int step = 3;
};
template <class M>
void send(ros::Publisher& pub, M& message) {
  Defaults<M> defaults;
  message.step = defaults.step;
  pub.publish(message);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  send(pub, image);
}
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1001 'send' asks for its type
// advertise src/node.cpp:21 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -void send(ros::Publisher& pub, M& message) {
// +void send(tzc::Publisher& pub, M& message) {
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
