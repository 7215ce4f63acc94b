// Options of two types in one function, by create().
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

void run(ros::NodeHandle& nh) {
  ros::SubscribeOptions images =
      ros::SubscribeOptions::create<sensor_msgs::Image>("image", 1, [](const sensor_msgs::ImageConstPtr&) {});
  ros::SubscribeOptions clouds;
  clouds =
      ros::SubscribeOptions::create<sensor_msgs::PointCloud2>("cloud", 1, [](const sensor_msgs::PointCloud2ConstPtr&) {});
  ros::Subscriber a = nh.subscribe(images), b = nh.subscribe(clouds);
}
//--- expected
// subscribe src/node.cpp:12 sensor_msgs/Image shared
// subscribe src/node.cpp:12 sensor_msgs/PointCloud2 shared
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber a = nh.subscribe(images), b = nh.subscribe(clouds);
// +  ros::Subscriber a = tzc::subscribe<sensor_msgs::Image>(nh, images), b = tzc::subscribe<sensor_msgs::PointCloud2>(nh, clouds);
