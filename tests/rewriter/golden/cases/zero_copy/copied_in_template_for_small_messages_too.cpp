// One instance of the template makes a message that has nothing to allocate.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

template <class M>
void relay(const ros::Publisher& to, const M& in) {
  M out = in;
  to.publish(out);
}

int main() {
  ros::NodeHandle nh;
  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher texts = nh.advertise<std_msgs::String>("text", 1);
  sensor_msgs::Image image;
  image.data.resize(100);
  relay(images, image);
  std_msgs::String text;
  relay(texts, text);
}
//--- expected
// publish src/node.cpp:9 sensor_msgs/Image zero_copy
// publish src/node.cpp:9 std_msgs/String not_needed
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:15 std_msgs/String not_needed 'text'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -void relay(const ros::Publisher& to, const M& in) {
// -  M out = in;
// +void relay(const tzc::Publisher& to, const M& in) {
// +  M out;
// +  to.allocate(out);
// +  out = in;
// -  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher texts = nh.advertise<std_msgs::String>("text", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher images = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  tzc::Publisher texts = tzc::advertise<std_msgs::String>(nh, "text", 1);
// +  tzc::sensor_msgs::Image image;
// +  images.allocate(image);
