// A copy of a published array shares its memory until it is written.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  pub.publish(image);
  auto copy = image.data;
  const auto& read = copy;
  const uint8_t* first = read.data();
  copy[0] = 1;
  image.width = *first;
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after its data was written to
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after its data was written to
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
