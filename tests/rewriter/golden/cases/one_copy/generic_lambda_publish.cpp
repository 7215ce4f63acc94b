// A generic lambda publishes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  auto send = [&](const auto& message) { pub.publish(message); };
  sensor_msgs::Image image;
  image.data.resize(100);
  send(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:7 sensor_msgs/Image one_copy 'image' TZC1019 it is built where its publisher cannot be named: 'pub' is a variable of another function
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
