// One message to all publishers of a vector: they are named after the message is filled.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(1);
    for (auto& pub : pubs_) pub.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  std::vector<ros::Publisher> pubs_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }
// +  Node() { pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;
