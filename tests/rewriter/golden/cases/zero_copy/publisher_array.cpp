// Publishers in an array, named by a constant.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    pubs_[0] = nh_.advertise<sensor_msgs::Image>("left", 1);
    pubs_[1] = nh_.advertise<sensor_msgs::Image>("right", 1);
  }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(1);
    pubs_[1].publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pubs_[2];
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'right'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pubs_[0] = nh_.advertise<sensor_msgs::Image>("left", 1);
// -    pubs_[1] = nh_.advertise<sensor_msgs::Image>("right", 1);
// +    pubs_[0] = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "left", 1);
// +    pubs_[1] = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "right", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pubs_[1].allocate(image);
// -  ros::Publisher pubs_[2];
// +  tzc::Publisher pubs_[2];
