// The advertise call comes from a macro: plain.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define ADVERTISE(nh, type, topic) nh.advertise<type>(topic, 1)

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = ADVERTISE(nh, sensor_msgs::Image, "image");
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image plain 'image' TZC1006 the advertise call comes from a macro
// publish src/node.cpp:11 sensor_msgs/Image plain 'image' TZC1006 the advertise call comes from a macro
