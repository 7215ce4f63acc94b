// A variable argument has the type that the function reads it as.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sys/ioctl.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  ioctl(3, 4, &image.data);
  pub.publish(image);
}
//--- expected
