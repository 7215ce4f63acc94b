// A filter with an initializer in the class.
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <vector>

class Node {
  ros::NodeHandle nh_;
  message_filters::Subscriber<sensor_msgs::Image> sub_{nh_, "image", 1};
};
Node node;
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  message_filters::Subscriber<sensor_msgs::Image> sub_{nh_, "image", 1};
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> sub_{nh_, "image", 1};
