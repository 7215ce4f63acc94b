// A class that inherits a filter's constructors.
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <vector>

class Frames : public message_filters::Subscriber<sensor_msgs::Image> {
 public:
  using message_filters::Subscriber<sensor_msgs::Image>::Subscriber;
};
void run(ros::NodeHandle& nh) { Frames frames(nh, "image", 1); }
//--- expected
// subscribe src/node.cpp:11 sensor_msgs/Image plain 'image' TZC2009 what holds the filter cannot be given another type
