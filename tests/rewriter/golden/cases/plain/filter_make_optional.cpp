// What make_optional makes a filter in is no place that can be given another type.
#include <message_filters/subscriber.h>
#include <optional>
#include <sensor_msgs/Image.h>

void seen(const sensor_msgs::ImageConstPtr&) {}

void run(ros::NodeHandle& nh) {
  auto frames = std::make_optional<message_filters::Subscriber<sensor_msgs::Image>>(nh, "image", 1);
  frames->registerCallback(seen);
}
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image plain 'image' TZC2009 what holds the filter cannot be given another type
