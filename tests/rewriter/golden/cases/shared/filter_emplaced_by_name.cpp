// Filters that a map makes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <message_filters/subscriber.h>
#include <map>
#include <tuple>

class Node {
 public:
  Node() {
    filters_.try_emplace("left", nh_, "left/image", 1);
    filters_.emplace(std::piecewise_construct, std::forward_as_tuple("right"),
                     std::forward_as_tuple(nh_, "right/image", 1));
  }

 private:
  ros::NodeHandle nh_;
  std::map<std::string, message_filters::Subscriber<sensor_msgs::Image>> filters_;
};
//--- expected
// subscribe src/node.cpp:12 sensor_msgs/Image shared 'left/image'
// subscribe src/node.cpp:13 sensor_msgs/Image shared 'right/image'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  std::map<std::string, message_filters::Subscriber<sensor_msgs::Image>> filters_;
// +  std::map<std::string, tzc::message_filters::Subscriber<sensor_msgs::Image>> filters_;
