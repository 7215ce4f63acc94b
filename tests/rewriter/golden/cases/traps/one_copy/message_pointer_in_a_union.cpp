// A union of a message's pointer and a number.
#include <cstdint>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

union Handle {
  sensor_msgs::Image* image;
  uintptr_t bits;
};

void fill(uintptr_t bits) { reinterpret_cast<sensor_msgs::Image*>(bits)->data.assign(20000, 5); }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  Handle handle;
  handle.image = &image;
  fill(handle.bits);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:20 sensor_msgs/Image one_copy 'image' TZC1001 a message that may be this one is cast from 'uintptr_t', which does not tell what lies there
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
