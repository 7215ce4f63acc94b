// A macro makes the message: its type stays, so it is copied.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define TOPIC "image"
#define NEW_IMAGE boost::make_shared<sensor_msgs::Image>()
#define EMPTY_IMAGE sensor_msgs::Image()

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(TOPIC, 1);
  auto made = NEW_IMAGE;
  made->data.resize(10);
  pub.publish(made);
  sensor_msgs::Image copied = EMPTY_IMAGE;
  copied.data.resize(10);
  pub.publish(copied);
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1006 its type is written by a macro
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1006 its type is written by a macro
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>(TOPIC, 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, TOPIC, 1);
