// A loop with structured bindings over publishers sends one message.
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <string>

class Node {
 public:
  Node() { pubs_["a"] = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void send() {
    sensor_msgs::Image image;
    image.data.resize(100);
    for (const auto& [name, pub] : pubs_) pub.publish(image);
  }
  ros::NodeHandle nh_;
  std::map<std::string, ros::Publisher> pubs_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pubs_["a"] = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pubs_["a"] = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  std::map<std::string, ros::Publisher> pubs_;
// +  std::map<std::string, tzc::Publisher> pubs_;
