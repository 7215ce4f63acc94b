// An earlier run kept the classes of filters that can be ported now.
#include <tzc/image_transport.h>
#include <tzc/message_filters.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : it_(nh) {
    tzc::message_filters::subscribe(image_, it_, "image", 1);
    tzc::message_filters::subscribe(*other_, nh, "other", 1);
  }

 private:
  image_transport::ImageTransport it_;
  image_transport::SubscriberFilter image_;
  message_filters::Subscriber<sensor_msgs::Image>* other_ = new message_filters::Subscriber<sensor_msgs::Image>;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'other'
//
// +++ src/node.cpp
// -    tzc::message_filters::subscribe(image_, it_, "image", 1);
// -    tzc::message_filters::subscribe(*other_, nh, "other", 1);
// +    image_.subscribe(it_, "image", 1);
// +    (*other_).subscribe(nh, "other", 1);
// -  image_transport::SubscriberFilter image_;
// -  message_filters::Subscriber<sensor_msgs::Image>* other_ = new message_filters::Subscriber<sensor_msgs::Image>;
// +  tzc::image_transport::SubscriberFilter image_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image>* other_ = new tzc::message_filters::Subscriber<sensor_msgs::Image>;
