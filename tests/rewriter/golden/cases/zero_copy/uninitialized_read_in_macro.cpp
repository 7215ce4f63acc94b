// A zero is read where a macro writes the name.
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define FIRST_OF_IT image.data[0]
uint8_t first = 1;

void run(ros::NodeHandle& nh, const uint8_t* pixels) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;

  image.data.resize(100);
  first = FIRST_OF_IT;
  memcpy(image.data.data(), pixels, 100);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
