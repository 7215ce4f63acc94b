// What stands between reads the container and the index, and changes neither.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    for (const char* topic : {"left", "right"})
      pubs_.push_back(nh_.advertise<sensor_msgs::Image>(topic, 10));
  }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(100);
    image.step = listeners();
    if (chosen_ < pubs_.size()) pubs_[chosen_].publish(image);
  }

 private:
  unsigned listeners() const { return chosen_ < pubs_.size() ? pubs_[chosen_].getNumSubscribers() : 0; }
  ros::NodeHandle nh_;
  unsigned chosen_ = 0;
  std::vector<ros::Publisher> pubs_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy
// publish src/node.cpp:15 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -      pubs_.push_back(nh_.advertise<sensor_msgs::Image>(topic, 10));
// +      pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh_, topic, 10));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(pubs_, chosen_).allocate(image);
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;
