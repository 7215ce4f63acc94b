// The array that was resized is not the one that is overwritten.
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh, const uint8_t* pixels) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image, next;
  sensor_msgs::Image* current = &image;
  sensor_msgs::Image*& same = current;
  current->data.resize(100);
  same = &next;
  memcpy(current->data.data(), pixels, 100);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image, next;
// -  sensor_msgs::Image* current = &image;
// -  sensor_msgs::Image*& same = current;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image, next;
// +  pub.allocate(image);
// +  pub.allocate(next);
// +  tzc::sensor_msgs::Image* current = &image;
// +  tzc::sensor_msgs::Image*& same = current;
