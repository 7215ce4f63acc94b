// A message that is published by a pointer to const, which a cast makes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->data.resize(100);
  pub.publish(boost::const_pointer_cast<const sensor_msgs::Image>(image));
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +  pub.allocate(*image);
// -  pub.publish(boost::const_pointer_cast<const sensor_msgs::Image>(image));
// +  pub.publish(boost::const_pointer_cast<const tzc::sensor_msgs::Image>(image));
