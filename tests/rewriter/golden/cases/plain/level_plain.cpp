// --level plain.
//RUN: level=plain
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image plain 'image' TZC1015 this run leaves everything on TCPROS
// publish src/node.cpp:10 sensor_msgs/Image plain 'image' TZC1015 this run leaves everything on TCPROS
