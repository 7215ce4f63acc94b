// A tuple with a publisher.
#include <functional>
#include <future>
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <thread>
#include <vector>

#include <tuple>
void run(ros::NodeHandle& nh) {
  auto entry = std::make_tuple(1, nh.advertise<sensor_msgs::Image>("image", 10));
  sensor_msgs::Image image;
  image.data.resize(100);
  std::get<1>(entry).publish(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  auto entry = std::make_tuple(1, nh.advertise<sensor_msgs::Image>("image", 10));
// -  sensor_msgs::Image image;
// +  auto entry = std::make_tuple(1, tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10));
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
