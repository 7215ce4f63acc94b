// A publisher is given to std::async.
#include <functional>
#include <future>
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <thread>
#include <vector>

void work(ros::Publisher pub) {
  sensor_msgs::Image image;
  image.data.resize(100);
  pub.publish(image);
}
void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  std::async(std::launch::async, work, pub).get();
}
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void work(ros::Publisher pub) {
// -  sensor_msgs::Image image;
// +void work(tzc::Publisher pub) {
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
