// A header of another package casts the const away, in a function or in an instance of a template.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <other/grower.h>

void image(const sensor_msgs::ImageConstPtr& image) {
  other::pad(image);
}

void cloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  other::grow_by_another(*cloud);
}

void run(ros::NodeHandle& nh) {
  ros::Subscriber a = nh.subscribe("a", 1, image);
  ros::Subscriber b = nh.subscribe("b", 1, cloud);
}
//--- expected
// subscribe src/node.cpp:17 sensor_msgs/Image plain 'a' TZC2002 'other::pad' casts const away from a message that may be this one
// subscribe src/node.cpp:18 sensor_msgs/PointCloud2 plain 'b' TZC2002 'other::grow_by_another' casts const away from a message that may be this one
