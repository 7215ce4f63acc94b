// The number of messages that the memory is for, of a queue that a macro or a constant names.
//RUN: measured=1000
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define TOPIC "image"
#define QUEUE 20
#define TWICE 10 + 10

const int constant = 20;

void run(ros::NodeHandle& nh, int number) {
  ros::Publisher by_macro = nh.advertise<sensor_msgs::Image>(TOPIC, QUEUE);
  ros::Publisher by_sum = nh.advertise<sensor_msgs::Image>(TOPIC, 2 * TWICE);
  ros::Publisher by_constant = nh.advertise<sensor_msgs::Image>(TOPIC, constant);
  ros::Publisher by_number = nh.advertise<sensor_msgs::Image>(TOPIC, number);
  sensor_msgs::Image image;
  image.data.resize(10);
  by_macro.publish(image);
  by_sum.publish(image);
  by_constant.publish(image);
  by_number.publish(image);
}
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:21 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:22 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher by_macro = nh.advertise<sensor_msgs::Image>(TOPIC, QUEUE);
// -  ros::Publisher by_sum = nh.advertise<sensor_msgs::Image>(TOPIC, 2 * TWICE);
// -  ros::Publisher by_constant = nh.advertise<sensor_msgs::Image>(TOPIC, constant);
// -  ros::Publisher by_number = nh.advertise<sensor_msgs::Image>(TOPIC, number);
// -  sensor_msgs::Image image;
// +  tzc::Publisher by_macro = tzc::advertise<tzc::sensor_msgs::Image>(nh, TOPIC, QUEUE, 132044);
// +  tzc::Publisher by_sum = tzc::advertise<tzc::sensor_msgs::Image>(nh, TOPIC, 2 * TWICE, 187063);
// +  tzc::Publisher by_constant = tzc::advertise<tzc::sensor_msgs::Image>(nh, TOPIC, constant, 132044);
// +  tzc::Publisher by_number = tzc::advertise<tzc::sensor_msgs::Image>(nh, TOPIC, number, 77026);
// +  tzc::sensor_msgs::Image image;
// +  by_macro.allocate(image);
