// One message, asked for and waited for inside of roscpp.
#include <ros/topic.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>

unsigned height(ros::NodeHandle& nh) {
  ros::topic::waitForMessage<sensor_msgs::Imu>("imu", nh);
  return ros::topic::waitForMessage<sensor_msgs::Image>("image", nh)->height;
}
//--- expected
// subscribe src/node.cpp:7 sensor_msgs/Imu not_needed 'imu'
// subscribe src/node.cpp:8 sensor_msgs/Image plain 'image' TZC2008 the call subscribes inside roscpp for one message
