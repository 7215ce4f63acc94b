// Another thread fills the sequence until it is waited for.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <thread>

class Node {
 public:
  Node() : setup_([this] { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }) {}
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(100);
    setup_.join();
    pubs_.front().publish(image);
  }

 private:
  ros::NodeHandle nh_;
  std::vector<ros::Publisher> pubs_;
  std::thread setup_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() : setup_([this] { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }) {}
// +  Node() : setup_([this] { pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)); }) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;
