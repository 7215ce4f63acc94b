// What would not compile is left.
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  message_filters::Subscriber<sensor_msgs::Image> filter(nh, "image", 1);
  static_assert(std::is_same<decltype(filter), message_filters::Subscriber<sensor_msgs::Image>>::value, "this one");
}
//--- expected
// subscribe src/node.cpp:6 sensor_msgs/Image plain 'image' TZC2005 ported, it would not compile: static assertion failed due to requirement 'std::is_same<tzc::message_filters::Subscriber<sensor_msgs::Image_<std::allocator<void>>>, message_filters::Subscriber<sensor_msgs::Image_<std::allocator<void>>>>::value': this one
