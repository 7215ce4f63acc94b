// The elements of another message lie in shared memory.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  sensor_msgs::Image next;
  next.data.swap(image.data);
  pub.publish(next);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  sensor_msgs::Image next;
// +  tzc::sensor_msgs::Image next;
// +  pub.allocate(next);
