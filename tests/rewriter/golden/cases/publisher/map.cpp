// Publishers in a map.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pubs_["left"] = nh_.advertise<sensor_msgs::Image>("left", 1); }
  void publish(const std::string& name) {
    sensor_msgs::Image image;
    image.data.resize(1);
    pubs_[name].publish(image);
  }

 private:
  ros::NodeHandle nh_;
  std::map<std::string, ros::Publisher> pubs_;
};
//===
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'left'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'left' TZC1019 it is built where its publisher can not be named
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pubs_["left"] = nh_.advertise<sensor_msgs::Image>("left", 1); }
// +  Node() { pubs_["left"] = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "left", 1, 0); }
// -  std::map<std::string, ros::Publisher> pubs_;
// +  std::map<std::string, tzc::Publisher> pubs_;
