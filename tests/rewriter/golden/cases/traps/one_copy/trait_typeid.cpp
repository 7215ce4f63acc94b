// typeid.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <typeinfo>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  image.encoding = typeid(image).name();
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1001 the program asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
