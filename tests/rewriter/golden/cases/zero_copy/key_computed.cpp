// Keys that can be computed anywhere.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <map>

class Node {
 public:
  Node() { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }
  void in_turn(unsigned n) {
    sensor_msgs::Image image;
    image.data.resize(100);
    if (n < turns_) pubs_[turns_ - n].publish(image);
  }
  void always(unsigned n) {
    sensor_msgs::Image image;
    image.data.resize(100);
    pubs_[n % turns_].publish(image);
  }

 private:
  ros::NodeHandle nh_;
  unsigned turns_ = 1;
  std::vector<ros::Publisher> pubs_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image", 1)); }
// +  Node() { pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(pubs_, turns_ - n).allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pubs_[n % turns_].allocate(image);
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;
