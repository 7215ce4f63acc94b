// In another configuration the macro gives its argument to a function that takes a std::vector.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void dump(const std::vector<uint8_t>& pixels);

#ifdef NODE_TRACE
#define TRACE(pixels) dump(pixels)
#else
#define TRACE(pixels)
#endif

void dump(const std::vector<uint8_t>& pixels) {
  for (uint8_t pixel : pixels) ROS_INFO("%u", pixel);
}

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  image.data.assign(n, 7);
  TRACE(image.data);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:18 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'image' TZC3007 the argument of a macro, which drops it in this configuration, names 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
