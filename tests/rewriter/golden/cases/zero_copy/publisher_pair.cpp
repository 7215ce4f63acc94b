// A pair with a publisher is made.
#include <functional>
#include <future>
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <thread>
#include <vector>

void run(ros::NodeHandle& nh) {
  auto entry = std::make_pair(1, nh.advertise<sensor_msgs::Image>("image", 10));
  sensor_msgs::Image image;
  image.data.resize(100);
  entry.second.publish(image);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  auto entry = std::make_pair(1, nh.advertise<sensor_msgs::Image>("image", 10));
// -  sensor_msgs::Image image;
// +  auto entry = std::make_pair(1, tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10));
// +  tzc::sensor_msgs::Image image;
// +  entry.second.allocate(image);
