// subscribe(SubscribeOptions).
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::SubscribeOptions options;
  options.init<sensor_msgs::Image>("image", 1, [](const sensor_msgs::ImageConstPtr&) {});
  ros::Subscriber sub = nh.subscribe(options);
}
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image shared
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber sub = nh.subscribe(options);
// +  ros::Subscriber sub = tzc::subscribe<sensor_msgs::Image>(nh, options);
