// The unit is compiled for release, so no parse of it shows what assert() is given: a debug build has to compile, too.
//RUN: flags=-DNDEBUG
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cassert>

bool is_black(const std::vector<uint8_t>& data) { return data[0] == 0; }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
  assert(is_black(image.data));
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1009 ported, it would not compile: no matching function for call to 'is_black'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
