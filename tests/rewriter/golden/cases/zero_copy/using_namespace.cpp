// using namespace: the name is written out.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

using namespace sensor_msgs;

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  Image image;
  ImagePtr shared(new Image);
  image.data.resize(1);
  shared->data.resize(1);
  pub.publish(image);
  pub.publish(shared);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  Image image;
// -  ImagePtr shared(new Image);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// +  tzc::sensor_msgs::ImagePtr shared(new tzc::sensor_msgs::Image);
// +  pub.allocate(*shared);
