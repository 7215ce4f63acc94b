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
// subscribe src/node.cpp:9 sensor_msgs/Image copied 'image' TZC2009 what holds the filter cannot be given another type, and message_filters' own class gets a copy, since it may pass it on to a writer
// subscribe src/node.cpp:11 sensor_msgs/Image copied 'other' TZC2009 what holds the filter cannot be given another type, and message_filters' own class gets a copy, since it may pass it on to a writer
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  void start(ros::NodeHandle& nh) { subscribe(nh, "image", 1); }
// +  void start(ros::NodeHandle& nh) { tzc::message_filters::subscribe(*this, nh, "image", 1); }
// -void run(ros::NodeHandle& nh) { Frames frames; frames.subscribe(nh, "other", 1); }
// +void run(ros::NodeHandle& nh) { Frames frames; tzc::message_filters::subscribe(frames, nh, "other", 1); }
