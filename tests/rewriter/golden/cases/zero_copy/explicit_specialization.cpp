// An explicit specialization for the message type is ported with its callers.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class M>
void fill(const M&, long) {}
template <class M>
void fill(M& message) { message.header.seq = 1; }
template <>
void fill(sensor_msgs::Image& message) { message.data[0] = 1; }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
  fill(image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void fill(sensor_msgs::Image& message) { message.data[0] = 1; }
// +void fill(tzc::sensor_msgs::Image& message) { message.data[0] = 1; }
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
