// A std::queue is a container, not a place where threads meet.
#include <queue>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;
std::queue<int> sizes;

void send() {
  sensor_msgs::Image image;
  sizes.push(3);
  while (sizes.size() > 2) sizes.pop();
  image.data.assign(sizes.front(), 1);
  pub.publish(image);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("image", 1);
  send();
}
//--- expected
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:21 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
