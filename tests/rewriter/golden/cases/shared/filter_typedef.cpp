// A typedef of a filter class.
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <vector>

typedef message_filters::Subscriber<sensor_msgs::Image> ImageSubscriber;
using Other = message_filters::Subscriber<sensor_msgs::Image>;
class Node {
 public:
  Node() : sub_(nh_, "image", 1) { other_.subscribe(nh_, "other", 1); }
  ros::NodeHandle nh_;
  ImageSubscriber sub_;
  Other other_;
};
//--- expected
// subscribe src/node.cpp:11 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:11 sensor_msgs/Image shared 'other'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  ImageSubscriber sub_;
// -  Other other_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> sub_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> other_;
