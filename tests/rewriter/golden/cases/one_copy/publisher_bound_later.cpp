// A function whose publisher is a placeholder.
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
  std::function<void(ros::Publisher)> send = std::bind(work, std::placeholders::_1);
  send(pub);
}
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image zero_copy
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1010 it is passed to 'std::function::operator()', which is not part of the package
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  pub.publish(image);
// +  tzc::publish(pub, image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  ros::Publisher pub = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", 10));
