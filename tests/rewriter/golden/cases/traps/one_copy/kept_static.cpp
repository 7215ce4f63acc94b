// A static message keeps its elements.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void publish(ros::NodeHandle& nh) {
  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  static sensor_msgs::Image image;
  image.data.push_back(1);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image one_copy 'image' TZC1022 line 8 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  static sensor_msgs::Image image;
// +  static tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  static tzc::sensor_msgs::Image image;
