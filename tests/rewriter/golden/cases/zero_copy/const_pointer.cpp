// Filled by Ptr, published as ConstPtr.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::ImagePtr image(new sensor_msgs::Image());
  image->data.resize(1);
  sensor_msgs::ImageConstPtr out = image;
  pub.publish(out);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image());
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image());
// +  pub.allocate(*image);
// -  sensor_msgs::ImageConstPtr out = image;
// +  tzc::sensor_msgs::ImageConstPtr out = image;
