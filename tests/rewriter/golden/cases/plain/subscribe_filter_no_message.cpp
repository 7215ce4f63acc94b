// A filter of what is no message: of another type with a serializer of its own, as topic_tools::ShapeShifter.
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>

struct AnyMessage {};

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : any_(nh, "any", 1), image_(nh, "image", 1) {}

 private:
  message_filters::Subscriber<AnyMessage> any_;
  message_filters::Subscriber<sensor_msgs::Image> image_;
};
//--- expected
// subscribe src/node.cpp:9 AnyMessage plain 'any' TZC2006 'AnyMessage' is no message
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  message_filters::Subscriber<sensor_msgs::Image> image_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> image_;
