// A macro of several lines at the top and no include in this file: the headers stand below it.
//--- src/node.cpp
#define USAGE "node <topic>\n" \
              "  topic: where to publish\n"
struct Before {};
#include "everything.h"

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//--- include/everything.h
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
