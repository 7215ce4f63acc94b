// The value of a statement expression behind a label.
#include <algorithm>
#include <iterator>
#include <utility>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  uint8_t* first = ({ [[maybe_unused]] here: &image.data[0]; });
  pub.publish(image);
  *first = 1;
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is the value of a statement expression
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is the value of a statement expression
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
