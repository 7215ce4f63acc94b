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
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'topic' TZC1007 the file is compiled in several ways, which advertise different types here
// advertise src/node.cpp:13 sensor_msgs/PointCloud2 one_copy 'topic' TZC1007 the file is compiled in several ways, which advertise different types here
// publish src/node.cpp:16 sensor_msgs/Image one_copy TZC1007 its type differs between the instances of a template, or the ways in which the file is compiled
// publish src/node.cpp:16 sensor_msgs/PointCloud2 one_copy TZC1007 its type differs between the instances of a template, or the ways in which the file is compiled
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<Message>("topic", 1);
// +  ros::Publisher pub = tzc::attached<Message>(nh.advertise<Message>("topic", 1));
