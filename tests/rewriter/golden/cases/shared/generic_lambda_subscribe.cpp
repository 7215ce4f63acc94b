// A generic lambda subscribes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void callback(const sensor_msgs::ImageConstPtr&) {}
void run(ros::NodeHandle& nh) {
  ros::Subscriber sub;
  auto connect = [&](auto topic) { sub = nh.subscribe(topic, 1, callback); };
  connect("image");
}
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image shared
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  auto connect = [&](auto topic) { sub = nh.subscribe(topic, 1, callback); };
// +  auto connect = [&](auto topic) { sub = tzc::subscribe(nh, topic, 1, callback); };
