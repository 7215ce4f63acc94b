// A publisher behind pointers.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() : pub_(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("image", 1))) {}
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(1);
    pub_->publish(image);
  }

 private:
  ros::NodeHandle nh_;
  boost::shared_ptr<ros::Publisher> pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() : pub_(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("image", 1))) {}
// +  Node() : pub_(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1))) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_->allocate(image);
// -  boost::shared_ptr<ros::Publisher> pub_;
// +  boost::shared_ptr<tzc::Publisher> pub_;
