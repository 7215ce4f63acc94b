// A camera's calibration has an array, but a light one.
//RUN: small=4096
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>

void take(const sensor_msgs::CameraInfoConstPtr&) {}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::CameraInfo>("camera_info", 10);
  ros::Subscriber sub = nh.subscribe("camera_info", 10, take);
  sensor_msgs::CameraInfo info;
  info.D.resize(5);
  pub.publish(info);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/CameraInfo not_needed 'camera_info' its arrays are light by their type
// subscribe src/node.cpp:10 sensor_msgs/CameraInfo not_needed 'camera_info' its arrays are light by their type
// publish src/node.cpp:13 sensor_msgs/CameraInfo not_needed 'camera_info' its arrays are light by their type
