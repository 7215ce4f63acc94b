// The base class's function, and not what overrides it: as a call of the object it could be the function around it.
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>

class Frames : public message_filters::Subscriber<sensor_msgs::Image> {
 public:
  void subscribe(ros::NodeHandle& nh) {
    message_filters::Subscriber<sensor_msgs::Image>::subscribe(nh, "image", 1);
  }
};
void run(ros::NodeHandle& nh) {
  Frames frames;
  frames.subscribe(nh);
}
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image plain 'image' TZC2009 what holds the filter cannot be given another type
