// A member of an object of a class template that is the same for all types.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class M>
struct Defaults {
  int step = 0;
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
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void send(ros::Publisher& pub, M& message) {
// +void send(tzc::Publisher& pub, M& message) {
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
