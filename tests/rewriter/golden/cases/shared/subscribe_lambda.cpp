// A lambda with the type written.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Subscriber a = nh.subscribe<sensor_msgs::Image>("a", 1, [](const sensor_msgs::ImageConstPtr& image) {});
}
//--- expected
// subscribe src/node.cpp:6 sensor_msgs/Image shared 'a'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber a = nh.subscribe<sensor_msgs::Image>("a", 1, [](const sensor_msgs::ImageConstPtr& image) {});
// +  ros::Subscriber a = tzc::subscribe<sensor_msgs::Image>(nh, "a", 1, [](const sensor_msgs::ImageConstPtr& image) {});
