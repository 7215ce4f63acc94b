// A filter that an initializer in the class makes with new.
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <vector>

class Node {
  ros::NodeHandle nh_;
  std::unique_ptr<message_filters::Subscriber<sensor_msgs::Image>> sub_{new message_filters::Subscriber<sensor_msgs::Image>(nh_, "image", 1)};
};
Node node;
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  std::unique_ptr<message_filters::Subscriber<sensor_msgs::Image>> sub_{new message_filters::Subscriber<sensor_msgs::Image>(nh_, "image", 1)};
// +  std::unique_ptr<tzc::message_filters::Subscriber<sensor_msgs::Image>> sub_{new tzc::message_filters::Subscriber<sensor_msgs::Image>(nh_, "image", 1)};
