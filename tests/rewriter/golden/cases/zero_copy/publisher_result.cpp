// A function makes the publisher.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher make(ros::NodeHandle& nh) { return nh.advertise<sensor_msgs::Image>("image", 1); }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = make(nh);
  sensor_msgs::Image image;
  image.data.resize(1);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:5 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -ros::Publisher make(ros::NodeHandle& nh) { return nh.advertise<sensor_msgs::Image>("image", 1); }
// +tzc::Publisher make(ros::NodeHandle& nh) { return tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1); }
// -  ros::Publisher pub = make(nh);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = make(nh);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
