// Entries of maps that cannot be looked up where the message is born.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <map>
#include <mutex>

int next();

class Node {
 public:
  Node() {
    pubs_[1] = nh_.advertise<sensor_msgs::Image>("one", 1);
  }
  void key_is_computed() {
    sensor_msgs::Image image;
    image.data.resize(1);
    pubs_[next()].publish(image);
  }
  void key_changes(int key) {
    sensor_msgs::Image image;
    image.data.resize(1);
    ++key;
    pubs_[key].publish(image);
  }
  void map_is_locked_later(int key) {
    sensor_msgs::Image image;
    image.data.resize(1);
    std::lock_guard<std::mutex> lock(mutex_);
    pubs_[key].publish(image);
  }

 private:
  ros::NodeHandle nh_;
  std::mutex mutex_;
  std::map<int, ros::Publisher> pubs_;
};
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'one'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'one'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'one'
// publish src/node.cpp:30 sensor_msgs/Image zero_copy 'one'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pubs_[1] = nh_.advertise<sensor_msgs::Image>("one", 1);
// +    pubs_[1] = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "one", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  std::map<int, ros::Publisher> pubs_;
// +  std::map<int, tzc::Publisher> pubs_;
