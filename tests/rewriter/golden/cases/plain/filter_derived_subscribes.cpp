// A class that is a filter subscribes.
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <vector>

class Frames : public message_filters::Subscriber<sensor_msgs::Image> {
 public:
  void start(ros::NodeHandle& nh) { subscribe(nh, "image", 1); }
};
void run(ros::NodeHandle& nh) { Frames frames; frames.subscribe(nh, "other", 1); }
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image plain 'image' TZC2009 what holds the filter cannot be given another type
// subscribe src/node.cpp:11 sensor_msgs/Image plain 'other' TZC2009 what holds the filter cannot be given another type
