// A zero is read as a field of what lies over the bytes.
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Header {
  uint8_t rows;
};

uint8_t first = 1;

void run(ros::NodeHandle& nh, const uint8_t* pixels) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  const Header* header = reinterpret_cast<const Header*>(&image.data[0]);
  image.data.resize(90);
  first = header->rows;
  memcpy(image.data.data(), pixels, 90);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
