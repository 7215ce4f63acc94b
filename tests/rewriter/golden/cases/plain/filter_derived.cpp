// A class that is a filter.
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <vector>

class Frames : public message_filters::Subscriber<sensor_msgs::Image> {
 public:
  explicit Frames(ros::NodeHandle& nh) : message_filters::Subscriber<sensor_msgs::Image>(nh, "image", 1) {}
};
void run(ros::NodeHandle& nh) { Frames frames(nh); }
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image plain 'image' TZC2009 what holds the filter cannot be given another type
