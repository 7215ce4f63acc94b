// A lambda keeps a pointer to an element it is given.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <algorithm>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  uint8_t* last = nullptr;
  std::for_each(image.data.begin(), image.data.end(), [&](uint8_t& pixel) { last = &pixel; });
  pub.publish(image);
  *last = 1;
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'last'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
