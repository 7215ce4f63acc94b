// Filters that are emplaced.
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <vector>

void run(ros::NodeHandle& nh) {
  std::vector<std::unique_ptr<message_filters::Subscriber<sensor_msgs::Image>>> subs;
  subs.emplace_back(new message_filters::Subscriber<sensor_msgs::Image>(nh, "image", 1));
  std::vector<message_filters::Subscriber<sensor_msgs::Image>> plain;
  plain.emplace_back(nh, "other", 1);
}
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:11 sensor_msgs/Image shared 'other'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  std::vector<std::unique_ptr<message_filters::Subscriber<sensor_msgs::Image>>> subs;
// -  subs.emplace_back(new message_filters::Subscriber<sensor_msgs::Image>(nh, "image", 1));
// -  std::vector<message_filters::Subscriber<sensor_msgs::Image>> plain;
// +  std::vector<std::unique_ptr<tzc::message_filters::Subscriber<sensor_msgs::Image>>> subs;
// +  subs.emplace_back(new tzc::message_filters::Subscriber<sensor_msgs::Image>(nh, "image", 1));
// +  std::vector<tzc::message_filters::Subscriber<sensor_msgs::Image>> plain;
