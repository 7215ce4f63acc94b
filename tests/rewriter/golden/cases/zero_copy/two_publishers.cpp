// One message to two publishers.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher raw = nh.advertise<sensor_msgs::Image>("raw", 10);
  ros::Publisher rect = nh.advertise<sensor_msgs::Image>("rect", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  raw.publish(image);
  rect.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'raw'
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'rect'
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'raw'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'rect'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher raw = nh.advertise<sensor_msgs::Image>("raw", 10);
// -  ros::Publisher rect = nh.advertise<sensor_msgs::Image>("rect", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher raw = tzc::advertise<tzc::sensor_msgs::Image>(nh, "raw", 10);
// +  tzc::Publisher rect = tzc::advertise<tzc::sensor_msgs::Image>(nh, "rect", 10);
// +  tzc::sensor_msgs::Image image;
// +  raw.allocate(image);
