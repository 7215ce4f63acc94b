// The topic is not a constant.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh, const std::string& name) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(name + "/image", 1);
  sensor_msgs::Image image;
  image.data.resize(1);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy
// publish src/node.cpp:9 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(name + "/image", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, name + "/image", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
