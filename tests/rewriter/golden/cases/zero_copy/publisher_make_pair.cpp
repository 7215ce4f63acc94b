// A publisher is put into a map by make_pair.
#include <functional>
#include <future>
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <thread>
#include <vector>

void run(ros::NodeHandle& nh) {
  std::map<int, ros::Publisher> pubs;
  pubs.insert(std::make_pair(1, nh.advertise<sensor_msgs::Image>("image", 10)));
  sensor_msgs::Image image;
  image.data.resize(100);
  pubs[1].publish(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  std::map<int, ros::Publisher> pubs;
// -  pubs.insert(std::make_pair(1, nh.advertise<sensor_msgs::Image>("image", 10)));
// -  sensor_msgs::Image image;
// +  std::map<int, tzc::Publisher> pubs;
// +  pubs.insert(std::make_pair(1, tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10)));
// +  tzc::sensor_msgs::Image image;
// +  tzc::find_publisher(pubs, 1).allocate(image);
