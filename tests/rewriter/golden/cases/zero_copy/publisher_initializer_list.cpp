// Publishers in an initializer list of a vector.
#include <functional>
#include <future>
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <thread>
#include <vector>

void run(ros::NodeHandle& nh) {
  std::vector<ros::Publisher> pubs{nh.advertise<sensor_msgs::Image>("a", 10), nh.advertise<sensor_msgs::Image>("b", 10)};
  sensor_msgs::Image image;
  image.data.resize(100);
  pubs[0].publish(image);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'a'
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'b'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  std::vector<ros::Publisher> pubs{nh.advertise<sensor_msgs::Image>("a", 10), nh.advertise<sensor_msgs::Image>("b", 10)};
// -  sensor_msgs::Image image;
// +  std::vector<tzc::Publisher> pubs{tzc::advertise<tzc::sensor_msgs::Image>(nh, "a", 10), tzc::advertise<tzc::sensor_msgs::Image>(nh, "b", 10)};
// +  tzc::sensor_msgs::Image image;
// +  pubs[0].allocate(image);
