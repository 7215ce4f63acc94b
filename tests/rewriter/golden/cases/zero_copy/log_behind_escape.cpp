// A pointer escaped. What is logged behind the publish goes to streams that have buffers of their own.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <fstream>
#include <iostream>
#include <sstream>

static uint8_t* raw;
static std::ofstream file("log");

void run(ros::NodeHandle& nh, bool verbose) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
  std::cout << "sent " << 1 << std::endl;
  std::cerr << "sent\n";
  (verbose ? std::clog : std::cerr) << 2;
  file << "sent " << 3 << std::endl;
  std::ostream& log = std::cout;
  log << 4;
  std::ostringstream text;
  text << "sent " << 5;
}
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
