// Publishers in a std::array.
#include <functional>
#include <future>
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <thread>
#include <vector>

#include <array>
void run(ros::NodeHandle& nh) {
  std::array<ros::Publisher, 2> pubs{{nh.advertise<sensor_msgs::Image>("a", 10), nh.advertise<sensor_msgs::Image>("b", 10)}};
  sensor_msgs::Image image;
  image.data.resize(100);
  pubs[1].publish(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'a'
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'b'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  std::array<ros::Publisher, 2> pubs{{nh.advertise<sensor_msgs::Image>("a", 10), nh.advertise<sensor_msgs::Image>("b", 10)}};
// -  sensor_msgs::Image image;
// +  std::array<tzc::Publisher, 2> pubs{{tzc::advertise<tzc::sensor_msgs::Image>(nh, "a", 10), tzc::advertise<tzc::sensor_msgs::Image>(nh, "b", 10)}};
// +  tzc::sensor_msgs::Image image;
// +  pubs[1].allocate(image);
