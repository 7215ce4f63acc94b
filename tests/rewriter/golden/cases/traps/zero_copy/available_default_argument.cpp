// In a default argument.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  static sensor_msgs::Image make() {
    sensor_msgs::Image image;
    image.data.resize(10);
    return image;
  }
  void send(sensor_msgs::Image image = make()) { pub_.publish(image); }

 private:
  ros::NodeHandle nh_;
  sensor_msgs::Image first_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// -  static sensor_msgs::Image make() {
// -    sensor_msgs::Image image;
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// +  static tzc::sensor_msgs::Image make() {
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  void send(sensor_msgs::Image image = make()) { pub_.publish(image); }
// +  void send(tzc::sensor_msgs::Image image = make()) { pub_.publish(image); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
