// What assert() is given compiles after as before, also through a macro of the package's own.
//RUN: flags=-DNDEBUG
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cassert>

#define CHECK_IMAGE(image) assert((image).data.size() == (image).width)

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.width = 10;
  image.data.resize(10);
  CHECK_IMAGE(image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
