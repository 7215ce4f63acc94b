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
