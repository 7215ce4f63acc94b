// A pair of publishers is bound.
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <string>

void run(ros::NodeHandle& nh) {
  std::pair<ros::Publisher, ros::Publisher> pubs(nh.advertise<sensor_msgs::Image>("a", 10), nh.advertise<sensor_msgs::Image>("b", 10));
  auto& [a, b] = pubs;
  sensor_msgs::Image image;
  image.data.resize(100);
  a.publish(image);
  b.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'a'
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'b'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy
// publish src/node.cpp:13 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  std::pair<ros::Publisher, ros::Publisher> pubs(nh.advertise<sensor_msgs::Image>("a", 10), nh.advertise<sensor_msgs::Image>("b", 10));
// +  std::pair<tzc::Publisher, tzc::Publisher> pubs(tzc::advertise<tzc::sensor_msgs::Image>(nh, "a", 10), tzc::advertise<tzc::sensor_msgs::Image>(nh, "b", 10));
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  a.allocate(image);
