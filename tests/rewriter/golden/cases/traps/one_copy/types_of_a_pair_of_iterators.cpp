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
