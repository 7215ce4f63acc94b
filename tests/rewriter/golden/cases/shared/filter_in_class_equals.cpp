// A filter with an initializer behind =.
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <vector>

class Node {
  ros::NodeHandle nh_;
  std::shared_ptr<message_filters::Subscriber<sensor_msgs::Image>> sub_ = std::make_shared<message_filters::Subscriber<sensor_msgs::Image>>(nh_, "image", 1);
};
Node node;
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  std::shared_ptr<message_filters::Subscriber<sensor_msgs::Image>> sub_ = std::make_shared<message_filters::Subscriber<sensor_msgs::Image>>(nh_, "image", 1);
// +  std::shared_ptr<tzc::message_filters::Subscriber<sensor_msgs::Image>> sub_ = std::make_shared<tzc::message_filters::Subscriber<sensor_msgs::Image>>(nh_, "image", 1);
