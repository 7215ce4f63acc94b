// The name of the function tells the type, and is published.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class M>
std::string type_of(const M&) {
  const std::string text = __PRETTY_FUNCTION__;
  return text.substr(text.find("M = "));
}

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  image.data.resize(n);
  image.encoding = type_of(image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1001 'type_of' asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
