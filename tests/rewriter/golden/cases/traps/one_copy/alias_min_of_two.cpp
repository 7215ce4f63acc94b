// A reference to the smaller of two elements.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <algorithm>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  const uint8_t& least = std::min(image.data[0], image.data[1]);
  pub.publish(image);
  image.data[0] = 1;
  image.height = least;
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1003 'least' points into its data and is used after the message may have been published
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 'least' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
