// A filter in a std::optional is emplaced.
#include <optional>
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <vector>

class Node {
 public:
  Node() { sub_.emplace(nh_, "image", 1); }
  ros::NodeHandle nh_;
  std::optional<message_filters::Subscriber<sensor_msgs::Image>> sub_;
};
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  std::optional<message_filters::Subscriber<sensor_msgs::Image>> sub_;
// +  std::optional<tzc::message_filters::Subscriber<sensor_msgs::Image>> sub_;
