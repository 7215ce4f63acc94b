// A template takes a copy of the array and hands it to an object of any type.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <any>

std::any last;

template <class T>
void keep(T value) {
  last = value;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  keep(image.data);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data goes to 'std::any::operator=', which asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
