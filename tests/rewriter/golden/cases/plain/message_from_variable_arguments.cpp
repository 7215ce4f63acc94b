// What is taken from variable arguments may have been passed as a pointer to a const message.
#include <cstdarg>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void grow(int count, ...) {
  va_list list;
  va_start(list, count);
  va_arg(list, sensor_msgs::Image*)->data.resize(5);
  va_end(list);
}

void on_image(const sensor_msgs::ImageConstPtr& image) {
  grow(1, image.get());
}

void run(ros::NodeHandle& nh) {
  ros::Subscriber sub = nh.subscribe("image", 1, on_image);
}
//--- expected
// subscribe src/node.cpp:19 sensor_msgs/Image plain 'image' TZC2002 const is cast away from a message that may be this one
