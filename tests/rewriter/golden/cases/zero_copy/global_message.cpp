// A global message and a global publisher.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;
sensor_msgs::Image image;

void publish() {
  image.data.resize(100);
  pub.publish(image);
}

int main() {
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("image", 1);
  publish();
}
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -ros::Publisher pub;
// -sensor_msgs::Image image;
// +tzc::Publisher pub;
// +tzc::sensor_msgs::Image image;
// -  pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
