// A type without arrays.
#include <ros/ros.h>
#include <sensor_msgs/Imu.h>

void callback(const sensor_msgs::Imu& imu) {}

void run(ros::NodeHandle& nh) {
  ros::Subscriber sub = nh.subscribe("imu", 1, callback);
}
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Imu not_needed 'imu'
