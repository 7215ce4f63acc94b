// Each compilation of the file advertises a type of its own.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#ifdef CLOUD
typedef sensor_msgs::PointCloud2 Message;
#else
typedef sensor_msgs::Image Message;
#endif

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<Message>("topic", 1);
  Message message;
  message.data.resize(10);
  pub.publish(message);
}
//--- src/cloud.cpp
#define CLOUD
#include "node.cpp"
//--- expected
