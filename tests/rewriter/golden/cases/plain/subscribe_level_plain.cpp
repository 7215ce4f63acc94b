// --level plain leaves everything.
//RUN: level=plain
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void callback(const sensor_msgs::ImageConstPtr& image) {}

void run(ros::NodeHandle& nh) {
  ros::Subscriber sub = nh.subscribe("image", 1, callback);
}
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image plain 'image' TZC2007 left out by --only, --except or --level
