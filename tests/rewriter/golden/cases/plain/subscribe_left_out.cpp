// --except.
//RUN: except=a
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void callback(const sensor_msgs::ImageConstPtr& image) {}

void run(ros::NodeHandle& nh) {
  ros::Subscriber a = nh.subscribe("a", 1, callback);
  ros::Subscriber b = nh.subscribe("b", 1, callback);
}
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image plain 'a' TZC2007 left out by --only, --except or --level
// subscribe src/node.cpp:10 sensor_msgs/Image shared 'b'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber b = nh.subscribe("b", 1, callback);
// +  ros::Subscriber b = tzc::subscribe(nh, "b", 1, callback);
