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
