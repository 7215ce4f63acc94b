// A method builds and returns the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  sensor_msgs::Image make() {
    sensor_msgs::Image image;
    image.data.resize(100);
    return image;
  }
  void publish() { pub_.publish(make()); }
  void publish_later() {
    sensor_msgs::Image image = make();
    image.header.seq = 1;
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// -  sensor_msgs::Image make() {
// -    sensor_msgs::Image image;
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// +  tzc::sensor_msgs::Image make() {
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image = make();
// +    tzc::sensor_msgs::Image image = make();
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
