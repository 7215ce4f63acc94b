// A filter whose type comes from a macro.
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>

#define FILTER message_filters::Subscriber<sensor_msgs::Image>

void run(ros::NodeHandle& nh) {
  FILTER filter(nh, "image", 1);
}
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image plain 'image' TZC1006 its type is written by a macro
