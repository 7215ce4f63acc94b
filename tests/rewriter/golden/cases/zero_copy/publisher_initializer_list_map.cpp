// Publishers in an initializer list of a map.
#include <functional>
#include <future>
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <thread>
#include <vector>

void run(ros::NodeHandle& nh) {
  std::map<int, ros::Publisher> pubs = {{1, nh.advertise<sensor_msgs::Image>("a", 10)}, {2, nh.advertise<sensor_msgs::Image>("b", 10)}};
  sensor_msgs::Image image;
  image.data.resize(100);
  pubs[1].publish(image);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'a'
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'b'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  std::map<int, ros::Publisher> pubs = {{1, nh.advertise<sensor_msgs::Image>("a", 10)}, {2, nh.advertise<sensor_msgs::Image>("b", 10)}};
// -  sensor_msgs::Image image;
// +  std::map<int, tzc::Publisher> pubs = {{1, tzc::advertise<tzc::sensor_msgs::Image>(nh, "a", 10)}, {2, tzc::advertise<tzc::sensor_msgs::Image>(nh, "b", 10)}};
// +  tzc::sensor_msgs::Image image;
// +  tzc::find_publisher(pubs, 1).allocate(image);
