// A filter that make_unique makes.
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <vector>

void run(ros::NodeHandle& nh) {
  auto sub = std::make_unique<message_filters::Subscriber<sensor_msgs::Image>>(nh, "image", 1);
}
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  auto sub = std::make_unique<message_filters::Subscriber<sensor_msgs::Image>>(nh, "image", 1);
// +  auto sub = std::make_unique<tzc::message_filters::Subscriber<sensor_msgs::Image>>(nh, "image", 1);
