// message_filters' own subscriber may pass a message on to a writer, so all callbacks of its topic get a copy.
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define FILTER message_filters::Subscriber<sensor_msgs::Image>

void seen(const sensor_msgs::ImageConstPtr&) {}

void run(ros::NodeHandle& nh) {
  FILTER filter(nh, "image", 1);
  ros::Subscriber same = nh.subscribe("image", 1, seen);
  message_filters::Subscriber<sensor_msgs::Image> ported(nh, "image", 1);
  ros::Subscriber other = nh.subscribe("other", 1, seen);
}
//--- expected
// subscribe src/node.cpp:11 sensor_msgs/Image plain 'image' TZC1006 its type is written by a macro
// subscribe src/node.cpp:12 sensor_msgs/Image copied 'image' TZC2001 an unported filter of the topic may pass the message to a writer, so all callbacks get copies
// subscribe src/node.cpp:13 sensor_msgs/Image copied 'image' TZC2001 an unported filter of the topic may pass the message to a writer, so all callbacks get copies
// subscribe src/node.cpp:14 sensor_msgs/Image shared 'other'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// +#include <tzc/ros.h>
// -  ros::Subscriber same = nh.subscribe("image", 1, seen);
// -  message_filters::Subscriber<sensor_msgs::Image> ported(nh, "image", 1);
// -  ros::Subscriber other = nh.subscribe("other", 1, seen);
// +  ros::Subscriber same = tzc::subscribe(nh, "image", 1, seen);
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> ported(nh, "image", 1);
// +  ros::Subscriber other = tzc::subscribe(nh, "other", 1, seen);
