// A filter behind a pointer, made with new and with make_shared.
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() : a_(new message_filters::Subscriber<sensor_msgs::Image>(nh_, "a", 1)) {
    b_ = boost::make_shared<message_filters::Subscriber<sensor_msgs::Image>>(nh_, "b", 1);
    a_->registerCallback(&Node::callback, this);
  }
  void callback(const sensor_msgs::ImageConstPtr& image) {}

 private:
  ros::NodeHandle nh_;
  boost::shared_ptr<message_filters::Subscriber<sensor_msgs::Image>> a_, b_;
};
//--- expected
// subscribe src/node.cpp:7 sensor_msgs/Image shared 'a'
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'b'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  Node() : a_(new message_filters::Subscriber<sensor_msgs::Image>(nh_, "a", 1)) {
// -    b_ = boost::make_shared<message_filters::Subscriber<sensor_msgs::Image>>(nh_, "b", 1);
// +  Node() : a_(new tzc::message_filters::Subscriber<sensor_msgs::Image>(nh_, "a", 1)) {
// +    b_ = boost::make_shared<tzc::message_filters::Subscriber<sensor_msgs::Image>>(nh_, "b", 1);
// -  boost::shared_ptr<message_filters::Subscriber<sensor_msgs::Image>> a_, b_;
// +  boost::shared_ptr<tzc::message_filters::Subscriber<sensor_msgs::Image>> a_, b_;
