// A template asks for the type of what it is given in a pair.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <type_traits>

template <class R>
uint32_t kind(const R& range) {
  return std::is_pointer<decltype(range.first)>::value ? 1 : 2;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  auto ends = std::minmax_element(image.data.begin(), image.data.end());
  image.step = kind(ends);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data goes to 'kind', which asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
