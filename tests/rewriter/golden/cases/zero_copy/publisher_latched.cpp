// Latched, with status callbacks, tracked object.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void connected(const ros::SingleSubscriberPublisher&) {}

void run(ros::NodeHandle& nh) {
  ros::Publisher a = nh.advertise<sensor_msgs::Image>("a", 1, true);
  ros::Publisher b = nh.advertise<sensor_msgs::Image>("b", 1, connected, connected);
  ros::Publisher c = nh.advertise<sensor_msgs::Image>("c", 1, &connected, &connected, ros::VoidConstPtr(), true);
  sensor_msgs::Image image;
  image.data.resize(1);
  a.publish(image);
  b.publish(image);
  c.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'a'
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'b'
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'c'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'a'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'b'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'c'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher a = nh.advertise<sensor_msgs::Image>("a", 1, true);
// -  ros::Publisher b = nh.advertise<sensor_msgs::Image>("b", 1, connected, connected);
// -  ros::Publisher c = nh.advertise<sensor_msgs::Image>("c", 1, &connected, &connected, ros::VoidConstPtr(), true);
// -  sensor_msgs::Image image;
// +  tzc::Publisher a = tzc::advertise<tzc::sensor_msgs::Image>(nh, "a", 1, true);
// +  tzc::Publisher b = tzc::advertise<tzc::sensor_msgs::Image>(nh, "b", 1, connected, connected);
// +  tzc::Publisher c = tzc::advertise<tzc::sensor_msgs::Image>(nh, "c", 1, &connected, &connected, ros::VoidConstPtr(), true);
// +  tzc::sensor_msgs::Image image;
// +  a.allocate(image);
