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
// advertise src/node.cpp:13 sensor_msgs/Image one_copy
// publish src/node.cpp:19 sensor_msgs/Image one_copy TZC1019 it is built where its publisher cannot be named: 'pubs_[chosen_]' of line 19 cannot, since 'pubs_' or the index may change in between
// publish src/node.cpp:25 sensor_msgs/Image one_copy TZC1019 it is built where its publisher cannot be named: 'pubs_[chosen_]' of line 25 cannot, since 'pubs_' or the index may change in between
// publish src/node.cpp:32 sensor_msgs/Image one_copy TZC1019 it is built where its publisher cannot be named: 'pubs_[i]' of line 32 cannot, since 'pubs_' or the index may change in between
// advertise src/node.cpp:38 sensor_msgs/Image one_copy 'middle'
// publish src/node.cpp:39 sensor_msgs/Image one_copy TZC1019 it is built where its publisher cannot be named: 'pubs_.front()' of line 39 cannot, since 'pubs_' or the index may change in between
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -      pubs_.push_back(nh_.advertise<sensor_msgs::Image>(topic, 10));
// +      pubs_.push_back(tzc::advertise<sensor_msgs::Image>(nh_, topic, 10));
// -    pubs_.push_back(nh_.advertise<sensor_msgs::Image>("middle", 10));
// +    pubs_.push_back(tzc::advertise<sensor_msgs::Image>(nh_, "middle", 10));
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;
