// In a function that an initializer calls.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() : first_(start()), pub_(nh_.advertise<sensor_msgs::Image>("image", 10)) { pub_.publish(first_); }
  sensor_msgs::Image start() { return make(); }
  sensor_msgs::Image make() {
    sensor_msgs::Image image;
    image.data.resize(10);
    return image;
  }

 private:
  ros::NodeHandle nh_;
  sensor_msgs::Image first_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() : first_(start()), pub_(nh_.advertise<sensor_msgs::Image>("image", 10)) { pub_.publish(first_); }
// -  sensor_msgs::Image start() { return make(); }
// -  sensor_msgs::Image make() {
// -    sensor_msgs::Image image;
// +  Node() : first_(start()), pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10)) { pub_.publish(first_); }
// +  tzc::sensor_msgs::Image start() { return make(); }
// +  tzc::sensor_msgs::Image make() {
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  sensor_msgs::Image first_;
// -  ros::Publisher pub_;
// +  tzc::sensor_msgs::Image first_;
// +  tzc::Publisher pub_;
