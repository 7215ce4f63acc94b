// A struct of publishers is bound.
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <string>

struct Pubs { ros::Publisher a, b; };
void run(ros::NodeHandle& nh) {
  Pubs pubs;
  pubs.a = nh.advertise<sensor_msgs::Image>("a", 10);
  pubs.b = nh.advertise<sensor_msgs::Image>("b", 10);
  auto& [a, b] = pubs;
  sensor_msgs::Image image;
  image.data.resize(100);
  a.publish(image);
  b.publish(image);
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'a'
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'b'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'a'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'b'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -struct Pubs { ros::Publisher a, b; };
// +struct Pubs { tzc::Publisher a, b; };
// -  pubs.a = nh.advertise<sensor_msgs::Image>("a", 10);
// -  pubs.b = nh.advertise<sensor_msgs::Image>("b", 10);
// +  pubs.a = tzc::advertise<tzc::sensor_msgs::Image>(nh, "a", 10);
// +  pubs.b = tzc::advertise<tzc::sensor_msgs::Image>(nh, "b", 10);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  a.allocate(image);
