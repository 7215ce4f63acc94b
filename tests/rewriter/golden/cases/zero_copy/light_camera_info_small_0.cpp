// --small=0: light messages are ported, too.
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::CameraInfo>("camera_info", 10);
  sensor_msgs::CameraInfo info;
  info.D.resize(5);
  pub.publish(info);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/CameraInfo zero_copy 'camera_info'
// publish src/node.cpp:9 sensor_msgs/CameraInfo zero_copy 'camera_info'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/CameraInfo.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::CameraInfo>("camera_info", 10);
// -  sensor_msgs::CameraInfo info;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::CameraInfo>(nh, "camera_info", 10);
// +  tzc::sensor_msgs::CameraInfo info;
// +  pub.allocate(info);
