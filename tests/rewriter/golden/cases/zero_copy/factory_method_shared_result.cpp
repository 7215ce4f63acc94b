// A method builds and returns a shared message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  sensor_msgs::ImagePtr make() {
    sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
    image->data.resize(100);
    return image;
  }
  void publish() { pub_.publish(make()); }

 private:
  ros::NodeHandle nh_;
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
// -  sensor_msgs::ImagePtr make() {
// -    sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// +  tzc::sensor_msgs::ImagePtr make() {
// +    tzc::sensor_msgs::ImagePtr image = boost::make_shared<tzc::sensor_msgs::Image>();
// +    pub_.allocate(*image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
