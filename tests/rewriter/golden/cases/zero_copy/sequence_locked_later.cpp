// Sequences that other threads may change until they are locked.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

class Node {
 public:
  Node() { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }
  void by_guard(unsigned n) {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::lock_guard<std::mutex> lock(mutex_);
    if (n < pubs_.size()) pubs_[n].publish(image);
  }
  void by_hand(unsigned n) {
    sensor_msgs::Image image;
    image.data.resize(100);
    mutex_.lock();
    if (n < pubs_.size()) pubs_[n].publish(image);
    mutex_.unlock();
  }

 private:
  ros::NodeHandle nh_;
  std::mutex mutex_;
  std::vector<ros::Publisher> pubs_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }
// +  Node() { pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;
