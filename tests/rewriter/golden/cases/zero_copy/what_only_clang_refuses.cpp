// GCC warns of it at most: a macro behind a literal without a blank, numbers narrowed in braces, register.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define VERSION "1.0"

void run(ros::NodeHandle& nh, int width, double height) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  const std::string version = "version "VERSION"";
  const float size[] = {width, height};
  register int count = width;
  sensor_msgs::Image image;
  image.header.frame_id = version;
  image.data.resize(count + size[0]);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
