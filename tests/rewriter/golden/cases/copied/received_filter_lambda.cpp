// The callback of a filter is a lambda that casts const away.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <message_filters/subscriber.h>

class Node {
 public:
  Node() : filter_(nh_, "image", 1) {
    filter_.registerCallback([](const sensor_msgs::ImageConstPtr& image) { const_cast<uint8_t&>(image->data[0]) = 1; });
  }

 private:
  ros::NodeHandle nh_;
  message_filters::Subscriber<sensor_msgs::Image> filter_;
};
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image copied 'image' TZC2001 const is cast away from its data: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  message_filters::Subscriber<sensor_msgs::Image> filter_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> filter_;
