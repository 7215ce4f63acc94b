// The callback of a filter that its class initialises takes the message as its own.
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Reader {
 public:
  Reader() { filter_.registerCallback(&Reader::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr&) {}

 private:
  ros::NodeHandle nh_;
  message_filters::Subscriber<sensor_msgs::Image> filter_{nh_, "read", 1};
};

class Writer {
 public:
  Writer() { filter_.registerCallback(&Writer::callback, this); }
  void callback(const ros::MessageEvent<sensor_msgs::Image>&) {}

 private:
  ros::NodeHandle nh_;
  message_filters::Subscriber<sensor_msgs::Image> filter_{nh_, "written", 1};
};
//--- expected
// subscribe src/node.cpp:13 sensor_msgs/Image shared 'read'
// subscribe src/node.cpp:23 sensor_msgs/Image copied 'written' TZC2001 the callback may write to the message, so it gets a copy of its own
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  message_filters::Subscriber<sensor_msgs::Image> filter_{nh_, "read", 1};
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> filter_{nh_, "read", 1};
// -  message_filters::Subscriber<sensor_msgs::Image> filter_{nh_, "written", 1};
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> filter_{nh_, "written", 1};
