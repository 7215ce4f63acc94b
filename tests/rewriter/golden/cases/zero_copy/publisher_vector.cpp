// Publishers in a vector, in a loop.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    for (int i = 0; i < 3; ++i) pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image" + std::to_string(i), 1));
  }
  void publish() {
    for (unsigned i = 0; i < pubs_.size(); ++i) {
      sensor_msgs::Image image;
      image.data.resize(1);
      pubs_[i].publish(image);
    }
  }

 private:
  ros::NodeHandle nh_;
  std::vector<ros::Publisher> pubs_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy
// publish src/node.cpp:14 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    for (int i = 0; i < 3; ++i) pubs_.push_back(nh_.advertise<sensor_msgs::Image>("image" + std::to_string(i), 1));
// +    for (int i = 0; i < 3; ++i) pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image" + std::to_string(i), 1));
// -      sensor_msgs::Image image;
// +      tzc::sensor_msgs::Image image;
// +      pubs_[i].allocate(image);
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;
