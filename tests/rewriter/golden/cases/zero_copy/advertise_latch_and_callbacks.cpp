// The memory size is written only where what follows could be taken for one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void connected(const ros::SingleSubscriberPublisher&) {}

void run(ros::NodeHandle& nh, int n, int latch) {
  ros::Publisher latched = nh.advertise<sensor_msgs::Image>("latched", 1, true);
  ros::Publisher by_number = nh.advertise<sensor_msgs::Image>("by_number", 1, latch);
  ros::Publisher called = nh.advertise<sensor_msgs::Image>("called", 1, connected);
  sensor_msgs::Image image;
  image.data.resize(n);
  latched.publish(image);
  by_number.publish(image);
  called.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'latched'
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'by_number'
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'called'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'latched'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'by_number'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'called'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher latched = nh.advertise<sensor_msgs::Image>("latched", 1, true);
// -  ros::Publisher by_number = nh.advertise<sensor_msgs::Image>("by_number", 1, latch);
// -  ros::Publisher called = nh.advertise<sensor_msgs::Image>("called", 1, connected);
// -  sensor_msgs::Image image;
// +  tzc::Publisher latched = tzc::advertise<tzc::sensor_msgs::Image>(nh, "latched", 1, true);
// +  tzc::Publisher by_number = tzc::advertise<tzc::sensor_msgs::Image>(nh, "by_number", 1, 0, latch);
// +  tzc::Publisher called = tzc::advertise<tzc::sensor_msgs::Image>(nh, "called", 1, 0, connected);
// +  tzc::sensor_msgs::Image image;
// +  latched.allocate(image);
