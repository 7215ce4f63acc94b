// No debug build compiles the original, so nothing tells what the port would do to it.
//RUN: flags=-DNDEBUG
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cassert>

bool is_black(const std::vector<uint8_t>& data) { return data[0] == 0; }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
  assert(is_black(image.data) && not_declared_any_more);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC3007 the argument of a macro, which drops it in this configuration, names 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
