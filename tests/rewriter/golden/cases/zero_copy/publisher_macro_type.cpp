// A macro names the type that is advertised: the call keeps it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define IMAGE sensor_msgs::Image
#define SPACE sensor_msgs
#define OF(space) space::Image

void run(ros::NodeHandle& nh) {
  ros::Publisher whole = nh.advertise<IMAGE>("whole", 1);
  ros::Publisher space = nh.advertise<SPACE::Image>("space", 1);
  ros::Publisher made = nh.advertise<OF(sensor_msgs)>("made", 1);
  sensor_msgs::Image image;
  image.data.resize(10);
  whole.publish(image);
  space.publish(image);
  made.publish(image);
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'whole'
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'space'
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'made'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'whole'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'space'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'made'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher whole = nh.advertise<IMAGE>("whole", 1);
// -  ros::Publisher space = nh.advertise<SPACE::Image>("space", 1);
// -  ros::Publisher made = nh.advertise<OF(sensor_msgs)>("made", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher whole = tzc::advertise<IMAGE>(nh, "whole", 1);
// +  tzc::Publisher space = tzc::advertise<SPACE::Image>(nh, "space", 1);
// +  tzc::Publisher made = tzc::advertise<OF(sensor_msgs)>(nh, "made", 1);
// +  tzc::sensor_msgs::Image image;
// +  whole.allocate(image);
