// Code that this configuration does not compile names the message: it cannot be verified, so the message stays.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void draw(sensor_msgs::Image& image);

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
#ifdef WITH_LOGO
  draw(image);
#endif
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC3007 a preprocessor branch that is not compiled here names 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
