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
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1019 it is built where its publisher cannot be named: 'pubs_.front()' of line 14 cannot, since another thread may be waited for in between, and may replace it
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() : setup_([this] { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }) {}
// +  Node() : setup_([this] { pubs_.push_back(tzc::advertise<sensor_msgs::Image>(nh_, "image", 1)); }) {}
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;
