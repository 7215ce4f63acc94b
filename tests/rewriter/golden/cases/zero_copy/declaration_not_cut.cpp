// A comment between two variables, a const behind the type, a for statement: such declarations stay whole.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher text = nh.advertise<std_msgs::String>("text", 1), /* for images: */ image =
                                                                       nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image message;
  message.data.resize(n);
  image.publish(message);
  text.publish(std_msgs::String());
  for (ros::Publisher a = nh.advertise<std_msgs::String>("text", 1), b = nh.advertise<sensor_msgs::Image>("b", 1);;) {
    b.publish(message);
    a.publish(std_msgs::String());
  }
}
//--- expected
// advertise src/node.cpp:7 std_msgs/String not_needed 'text'
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 std_msgs/String not_needed 'text'
// advertise src/node.cpp:13 std_msgs/String not_needed 'text'
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'b'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'b'
// publish src/node.cpp:15 std_msgs/String not_needed 'text'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -  ros::Publisher text = nh.advertise<std_msgs::String>("text", 1), /* for images: */ image =
// -                                                                       nh.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image message;
// +  tzc::Publisher text = tzc::advertise<std_msgs::String>(nh, "text", 1), /* for images: */ image =
// +                                                                       tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  tzc::sensor_msgs::Image message;
// +  image.allocate(message);
// -  for (ros::Publisher a = nh.advertise<std_msgs::String>("text", 1), b = nh.advertise<sensor_msgs::Image>("b", 1);;) {
// +  for (tzc::Publisher a = tzc::advertise<std_msgs::String>(nh, "text", 1), b = tzc::advertise<tzc::sensor_msgs::Image>(nh, "b", 1);;) {
