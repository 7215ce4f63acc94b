// Variables that a header declares and a file defines: one cut would not do.
#include <node.h>

ros::Publisher image_pub, text_pub;
void publish(int n) {
  sensor_msgs::Image image;
  image.data.resize(n);
  image_pub.publish(image);
  text_pub.publish(std_msgs::String());
}
//--- include/node.h
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

extern ros::Publisher image_pub, text_pub;
//--- src/main.cpp
#include <node.h>

void start(ros::NodeHandle& nh) {
  image_pub = nh.advertise<sensor_msgs::Image>("image", 1);
  text_pub = nh.advertise<std_msgs::String>("text", 1);
}
//--- expected
// advertise src/main.cpp:4 sensor_msgs/Image zero_copy 'image'
// advertise src/main.cpp:5 std_msgs/String not_needed 'text'
// publish src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:9 std_msgs/String not_needed 'text'
//
// +++ include/node.h
// +#include <tzc/ros.h>
// -extern ros::Publisher image_pub, text_pub;
// +extern tzc::Publisher image_pub, text_pub;
//
// +++ src/main.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  image_pub = nh.advertise<sensor_msgs::Image>("image", 1);
// -  text_pub = nh.advertise<std_msgs::String>("text", 1);
// +  image_pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  text_pub = tzc::advertise<std_msgs::String>(nh, "text", 1);
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -ros::Publisher image_pub, text_pub;
// +tzc::Publisher image_pub, text_pub;
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  image_pub.allocate(image);
