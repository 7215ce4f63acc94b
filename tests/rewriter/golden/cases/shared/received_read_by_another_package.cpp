// A header of another package reads what it is given.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <other/grower.h>

void image(const sensor_msgs::ImageConstPtr& image) {
  ROS_INFO("%zu bytes", other::size_of(*image));
}

void run(ros::NodeHandle& nh) {
  ros::Subscriber sub = nh.subscribe("image", 1, image);
}
//--- expected
// subscribe src/node.cpp:12 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber sub = nh.subscribe("image", 1, image);
// +  ros::Subscriber sub = tzc::subscribe(nh, "image", 1, image);
