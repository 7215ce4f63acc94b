// memcpy and a pointer that ends before the publish.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <cstring>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  uint8_t pixels[100] = {0};
  memcpy(&image.data[0], pixels, 100);
  uint8_t* row = image.data.data() + 10;
  for (int i = 0; i < 10; ++i) row[i] = i;
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
