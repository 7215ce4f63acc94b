// allocate takes one message, and a pointer to an array does not lead to one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;

void owned(int size) {
  std::unique_ptr<sensor_msgs::Image[]> images(new sensor_msgs::Image[2]);
  images[0].data.resize(size);
  images[1].data.resize(size);
  pub.publish(images[0]);
  pub.publish(images[1]);
}
void made(int size) {
  auto images = std::make_unique<sensor_msgs::Image[]>(2);
  images[1].data.resize(size);
  pub.publish(images[1]);
}
void raw(int size) {
  sensor_msgs::Image* images = new sensor_msgs::Image[2];
  images[1].data.resize(size);
  pub.publish(images[1]);
  delete[] images;
}

int main() {
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("out", 1);
  owned(100);
  made(100);
  raw(100);
}
//--- expected
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'out' TZC1019 it is one of several that are made at once
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'out' TZC1019 it is one of several that are made at once
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'out' TZC1019 where it is built was not found
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'out' TZC1019 it is one of several that are made at once
// advertise src/node.cpp:28 sensor_msgs/Image one_copy 'out'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("out", 1);
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "out", 1);
