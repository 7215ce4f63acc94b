// std::is_same in a template.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <type_traits>

template <class M>
int kind(const M&) {
  return std::is_same<M, sensor_msgs::Image>::value;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  image.height = kind(image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1001 'kind' asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
