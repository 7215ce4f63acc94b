// Arrays whose size a macro writes, and that are overwritten whole.
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

#define WIDTH 64
#define HEIGHT (48)
#define AREA WIDTH * HEIGHT

void run(ros::NodeHandle& nh, const uint8_t* pixels) {
  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(WIDTH * HEIGHT);
  memcpy(&image.data[0], pixels, WIDTH * HEIGHT);
  images.publish(image);
  sensor_msgs::Image other;
  other.data.resize(AREA);
  for (int i = 0; i < AREA; ++i) other.data[i] = 1;
  images.publish(other);
  sensor_msgs::Image of_size;
  of_size.data.resize(HEIGHT);
  memcpy(&of_size.data[0], pixels, of_size.data.size());
  images.publish(of_size);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// -  image.data.resize(WIDTH * HEIGHT);
// +  tzc::Publisher images = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  images.allocate(image);
// +  image.data.resize(WIDTH * HEIGHT, tzc::uninitialized);
// -  sensor_msgs::Image other;
// -  other.data.resize(AREA);
// +  tzc::sensor_msgs::Image other;
// +  images.allocate(other);
// +  other.data.resize(AREA, tzc::uninitialized);
// -  sensor_msgs::Image of_size;
// -  of_size.data.resize(HEIGHT);
// +  tzc::sensor_msgs::Image of_size;
// +  images.allocate(of_size);
// +  of_size.data.resize(HEIGHT, tzc::uninitialized);
