// A manipulator of the package writes through a pointer that escaped.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <iostream>

static uint8_t* raw;
static std::ostream& late(std::ostream& out) {
  *raw = 1;
  return out;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
  std::cout << late;
}
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
