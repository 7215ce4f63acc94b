// What a typedef names leads to the filter, so the filter keeps its class.
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>

typedef boost::shared_ptr<message_filters::Subscriber<sensor_msgs::Image>> SubPtr;

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : sub_(new message_filters::Subscriber<sensor_msgs::Image>) {
    sub_->subscribe(nh, "image", 1);
    sub_->registerCallback(&Node::callback, this);
  }
  void callback(const sensor_msgs::ImageConstPtr&) {}

 private:
  SubPtr sub_;
};
//--- expected
// subscribe src/node.cpp:11 sensor_msgs/Image copied 'image' TZC1005 its type hides behind the name 'SubPtr', and message_filters' own class gets a copy, since it may pass it on to a writer
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -    sub_->subscribe(nh, "image", 1);
// +    tzc::message_filters::subscribe(*sub_, nh, "image", 1);
