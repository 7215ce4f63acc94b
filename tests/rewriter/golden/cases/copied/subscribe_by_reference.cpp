// Callback by const reference, value, non-const pointer, MessageEvent.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void by_reference(const sensor_msgs::Image& image) {}
void by_value(sensor_msgs::Image image) {}
void by_pointer(const sensor_msgs::ImagePtr& image) {}
void by_const_pointer(sensor_msgs::ImageConstPtr image) {}
void by_event(const ros::MessageEvent<sensor_msgs::Image const>& event) {}
void by_writing_event(const ros::MessageEvent<sensor_msgs::Image>& event) {}

void run(ros::NodeHandle& nh) {
  ros::Subscriber a = nh.subscribe("a", 1, by_reference);
  ros::Subscriber b = nh.subscribe("b", 1, by_value);
  ros::Subscriber c = nh.subscribe("c", 1, by_pointer);
  ros::Subscriber d = nh.subscribe("d", 1, by_const_pointer);
  ros::Subscriber e = nh.subscribe("e", 1, by_event);
  ros::Subscriber f = nh.subscribe("f", 1, by_writing_event);
}
//--- expected
// subscribe src/node.cpp:13 sensor_msgs/Image shared 'a'
// subscribe src/node.cpp:14 sensor_msgs/Image copied 'b' TZC2001 the callback may write to the message, so it gets a copy of its own
// subscribe src/node.cpp:15 sensor_msgs/Image copied 'c' TZC2001 the callback may write to the message, so it gets a copy of its own
// subscribe src/node.cpp:16 sensor_msgs/Image shared 'd'
// subscribe src/node.cpp:17 sensor_msgs/Image shared 'e'
// subscribe src/node.cpp:18 sensor_msgs/Image copied 'f' TZC2001 the callback may write to the message, so it gets a copy of its own
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber a = nh.subscribe("a", 1, by_reference);
// -  ros::Subscriber b = nh.subscribe("b", 1, by_value);
// -  ros::Subscriber c = nh.subscribe("c", 1, by_pointer);
// -  ros::Subscriber d = nh.subscribe("d", 1, by_const_pointer);
// -  ros::Subscriber e = nh.subscribe("e", 1, by_event);
// -  ros::Subscriber f = nh.subscribe("f", 1, by_writing_event);
// +  ros::Subscriber a = tzc::subscribe(nh, "a", 1, by_reference);
// +  ros::Subscriber b = tzc::subscribe(nh, "b", 1, by_value);
// +  ros::Subscriber c = tzc::subscribe(nh, "c", 1, by_pointer);
// +  ros::Subscriber d = tzc::subscribe(nh, "d", 1, by_const_pointer);
// +  ros::Subscriber e = tzc::subscribe(nh, "e", 1, by_event);
// +  ros::Subscriber f = tzc::subscribe(nh, "f", 1, by_writing_event);
