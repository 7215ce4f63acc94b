// A publisher is emplaced in a vector.
#include <functional>
#include <future>
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <thread>
#include <vector>

void run(ros::NodeHandle& nh) {
  std::vector<ros::Publisher> pubs;
  pubs.emplace_back(nh.advertise<sensor_msgs::Image>("image", 10));
  sensor_msgs::Image image;
  image.data.resize(100);
  pubs[0].publish(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  std::vector<ros::Publisher> pubs;
// -  pubs.emplace_back(nh.advertise<sensor_msgs::Image>("image", 10));
// -  sensor_msgs::Image image;
// +  std::vector<tzc::Publisher> pubs;
// +  pubs.emplace_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10));
// +  tzc::sensor_msgs::Image image;
// +  pubs[0].allocate(image);
