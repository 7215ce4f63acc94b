// advertise(AdvertiseOptions).
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::AdvertiseOptions options;
  options.init<sensor_msgs::Image>("image", 1);
  ros::Publisher pub = nh.advertise(options);
  sensor_msgs::Image image;
  image.data.resize(1);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy
// publish src/node.cpp:11 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise(options);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, options);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
