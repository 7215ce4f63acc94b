// The name means another publisher where the message is made.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void choose(unsigned& i) {
  i = 1;
}

class Node {
 public:
  Node() {
    for (const char* topic : {"left", "right"})
      pubs_.push_back(nh_.advertise<sensor_msgs::Image>(topic, 10));
  }
  void by_assignment() {
    sensor_msgs::Image image;
    image.data.resize(100);
    chosen_ = (chosen_ + 1) % 2;
    pubs_[chosen_].publish(image);
  }
  void by_method() {
    sensor_msgs::Image image;
    image.data.resize(100);
    next();
    if (chosen_ < pubs_.size()) pubs_[chosen_].publish(image);
  }
  void by_reference() {
    unsigned i = 0;
    sensor_msgs::Image image;
    image.data.resize(100);
    choose(i);
    pubs_[i].publish(image);
  }
  void by_container() {
    sensor_msgs::Image image;
    image.data.resize(100);
    pubs_.clear();
    pubs_.push_back(nh_.advertise<sensor_msgs::Image>("middle", 10));
    pubs_.front().publish(image);
  }

 private:
  void next() { ++chosen_; }
  ros::NodeHandle nh_;
  unsigned chosen_ = 0;
  std::vector<ros::Publisher> pubs_;
};
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy
// publish src/node.cpp:19 sensor_msgs/Image zero_copy
// publish src/node.cpp:25 sensor_msgs/Image zero_copy
// publish src/node.cpp:32 sensor_msgs/Image zero_copy
// advertise src/node.cpp:38 sensor_msgs/Image zero_copy 'middle'
// publish src/node.cpp:39 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -      pubs_.push_back(nh_.advertise<sensor_msgs::Image>(topic, 10));
// +      pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh_, topic, 10));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    pubs_.push_back(nh_.advertise<sensor_msgs::Image>("middle", 10));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "middle", 10));
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;
