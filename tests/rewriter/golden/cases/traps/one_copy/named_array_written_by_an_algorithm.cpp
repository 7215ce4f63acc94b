// An algorithm gets an element by const access and writes to the elements: what it looks for changes when it is found.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  pub.publish(image);
  const auto& read = image.data;
  std::replace(image.data.begin(), image.data.end(), read[0], uint8_t(5));
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is used after its data was written to
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is used after its data was written to
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
