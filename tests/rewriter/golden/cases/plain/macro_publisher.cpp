// The publisher type comes from a macro: plain.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define PUBLISHER ros::Publisher

void run(ros::NodeHandle& nh) {
  PUBLISHER pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image plain 'image' TZC1006 its type is written by a macro
// publish src/node.cpp:11 sensor_msgs/Image plain 'image' TZC1006 its type is written by a macro
