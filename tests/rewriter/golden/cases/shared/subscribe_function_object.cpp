// boost::function with two template arguments.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  boost::function<void(const sensor_msgs::ImageConstPtr&)> callback = [](const sensor_msgs::ImageConstPtr&) {};
  ros::Subscriber a = nh.subscribe<sensor_msgs::Image>("a", 1, callback);
  boost::function<void(const sensor_msgs::Image&)> by_reference = [](const sensor_msgs::Image&) {};
  ros::Subscriber b = nh.subscribe<sensor_msgs::Image, const sensor_msgs::Image&>("b", 1, by_reference);
}
//--- expected
// subscribe src/node.cpp:7 sensor_msgs/Image shared 'a'
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'b'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber a = nh.subscribe<sensor_msgs::Image>("a", 1, callback);
// +  ros::Subscriber a = tzc::subscribe<sensor_msgs::Image>(nh, "a", 1, callback);
// -  ros::Subscriber b = nh.subscribe<sensor_msgs::Image, const sensor_msgs::Image&>("b", 1, by_reference);
// +  ros::Subscriber b = tzc::subscribe<sensor_msgs::Image, const sensor_msgs::Image&>(nh, "b", 1, by_reference);
