// A logging macro between the message and its publisher, which a vector has: its control flow stays within it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Location {
  bool initialized, enabled;
};
inline void initialize(Location* location) {
  location->initialized = true;
}
inline void print(const Location&, const char*, ...) {}

#define LOG_THROTTLE(period, ...)                      \
  do {                                                 \
    static Location location = {false, false};         \
    static double last = 0;                            \
    if (!location.initialized) initialize(&location);  \
    const double now = ros::Time::now().toSec();       \
    if (location.enabled && (now - last > (period))) { \
      last = now;                                      \
      print(location, __VA_ARGS__);                    \
    }                                                  \
  } while (false)

class Node {
 public:
  Node() { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }
  void publish(unsigned n) {
    for (std::size_t i = 0; i < pubs_.size(); ++i) {
      sensor_msgs::Image image;
      image.data.resize(n);
      LOG_THROTTLE(1.0, "camera %zu", i);
      pubs_[i].publish(image);
    }
  }

 private:
  ros::NodeHandle nh_;
  std::vector<ros::Publisher> pubs_;
};
//--- expected
// advertise src/node.cpp:27 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:33 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }
// +  Node() { pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)); }
// -      sensor_msgs::Image image;
// +      tzc::sensor_msgs::Image image;
// +      pubs_[i].allocate(image);
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;
