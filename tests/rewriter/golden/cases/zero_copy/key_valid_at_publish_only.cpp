// Keys that can't be computed where the message is born: a division by zero, a string of a null pointer, side effects.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <map>

struct Key {
  Key(int number) : value(number) { ++made; }
  bool operator<(const Key& other) const { return value < other.value; }
  int value;
  static int made;
};

class Node {
 public:
  Node() { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }
  void in_turn(unsigned n, unsigned turns) {
    sensor_msgs::Image image;
    image.data.resize(100);
    if (turns > 0) pubs_[n % turns].publish(image);
  }
  void by_name(const char* name) {
    sensor_msgs::Image image;
    image.data.resize(100);
    if (name) named_[name].publish(image);
  }
  void next() {
    sensor_msgs::Image image;
    image.data.resize(100);
    pubs_.at(last_ = 0).publish(image);
  }
  void by_key(int number) {
    sensor_msgs::Image image;
    image.data.resize(100);
    keyed_[Key(number)].publish(image);
  }

 private:
  ros::NodeHandle nh_;
  unsigned last_ = 0;
  std::vector<ros::Publisher> pubs_;
  std::map<std::string, ros::Publisher> named_{{"one", nh_.advertise<sensor_msgs::Image>("one", 1)}};
  std::map<Key, ros::Publisher> keyed_{{Key(1), nh_.advertise<sensor_msgs::Image>("keyed", 1)}};
};
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:25 sensor_msgs/Image zero_copy 'one'
// publish src/node.cpp:30 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:35 sensor_msgs/Image zero_copy 'keyed'
// advertise src/node.cpp:42 sensor_msgs/Image zero_copy 'one'
// advertise src/node.cpp:43 sensor_msgs/Image zero_copy 'keyed'
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
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  std::vector<ros::Publisher> pubs_;
// -  std::map<std::string, ros::Publisher> named_{{"one", nh_.advertise<sensor_msgs::Image>("one", 1)}};
// -  std::map<Key, ros::Publisher> keyed_{{Key(1), nh_.advertise<sensor_msgs::Image>("keyed", 1)}};
// +  std::vector<tzc::Publisher> pubs_;
// +  std::map<std::string, tzc::Publisher> named_{{"one", tzc::advertise<tzc::sensor_msgs::Image>(nh_, "one", 1)}};
// +  std::map<Key, tzc::Publisher> keyed_{{Key(1), tzc::advertise<tzc::sensor_msgs::Image>(nh_, "keyed", 1)}};
