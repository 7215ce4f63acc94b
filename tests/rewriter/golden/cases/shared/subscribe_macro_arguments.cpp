// Subscriptions whose arguments macros write; the rest of the arguments may come from one.
#include <image_transport/image_transport.h>
#include <image_transport/subscriber_filter.h>
#include <message_filters/subscriber.h>

#define TOPIC "image"
#define QUEUE 1
#define NAME(x) "camera/" x
#define CALLBACK ::on_image
#define METHOD(x) &Node::x, this
#define IMAGE sensor_msgs::Image

void on_image(const sensor_msgs::ImageConstPtr& image) {}

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : it_(nh), filter_(nh, TOPIC, QUEUE), transport_(it_, TOPIC, QUEUE) {
    subs_.push_back(nh.subscribe(TOPIC, 1, ::on_image));
    subs_.push_back(nh.subscribe(NAME("image"), QUEUE, CALLBACK));
    subs_.push_back(nh.subscribe(NAME(TOPIC), QUEUE, METHOD(on_image)));
    subs_.push_back(nh.subscribe<IMAGE>(std::string("camera/") + TOPIC, QUEUE, ::on_image));
    image_ = it_.subscribe(TOPIC, QUEUE, &Node::on_image, this);
    other_.subscribe(nh, NAME("other"), QUEUE);
  }
  void on_image(const sensor_msgs::ImageConstPtr& image) {}

 private:
  image_transport::ImageTransport it_;
  std::vector<ros::Subscriber> subs_;
  image_transport::Subscriber image_;
  message_filters::Subscriber<sensor_msgs::Image> filter_, other_;
  image_transport::SubscriberFilter transport_;
};
//--- expected
// subscribe src/node.cpp:17 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:17 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:18 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:19 sensor_msgs/Image shared 'camera/image'
// subscribe src/node.cpp:20 sensor_msgs/Image shared 'camera/image'
// subscribe src/node.cpp:21 sensor_msgs/Image shared
// subscribe src/node.cpp:22 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:23 sensor_msgs/Image shared 'camera/other'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/message_filters.h>
// +#include <tzc/ros.h>
// -    subs_.push_back(nh.subscribe(TOPIC, 1, ::on_image));
// -    subs_.push_back(nh.subscribe(NAME("image"), QUEUE, CALLBACK));
// -    subs_.push_back(nh.subscribe(NAME(TOPIC), QUEUE, METHOD(on_image)));
// -    subs_.push_back(nh.subscribe<IMAGE>(std::string("camera/") + TOPIC, QUEUE, ::on_image));
// -    image_ = it_.subscribe(TOPIC, QUEUE, &Node::on_image, this);
// +    subs_.push_back(tzc::subscribe(nh, TOPIC, 1, ::on_image));
// +    subs_.push_back(tzc::subscribe(nh, NAME("image"), QUEUE, CALLBACK));
// +    subs_.push_back(tzc::subscribe(nh, NAME(TOPIC), QUEUE, METHOD(on_image)));
// +    subs_.push_back(tzc::subscribe<IMAGE>(nh, std::string("camera/") + TOPIC, QUEUE, ::on_image));
// +    image_ = tzc::image_transport::subscribe(it_, TOPIC, QUEUE, &Node::on_image, this);
// -  message_filters::Subscriber<sensor_msgs::Image> filter_, other_;
// -  image_transport::SubscriberFilter transport_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> filter_, other_;
// +  tzc::image_transport::SubscriberFilter transport_;
