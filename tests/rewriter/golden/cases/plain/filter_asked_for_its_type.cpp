// The program asks for the filter's type.
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  message_filters::Subscriber<sensor_msgs::Image> filter(nh, "image", 1);
  static_assert(std::is_same<decltype(filter), message_filters::Subscriber<sensor_msgs::Image>>::value, "this one");
}
//--- expected
// subscribe src/node.cpp:6 sensor_msgs/Image plain 'image' TZC1010 the program asks for its type
