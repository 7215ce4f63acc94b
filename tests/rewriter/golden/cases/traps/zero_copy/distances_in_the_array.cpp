// Distances between elements, and text that elements hold.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

class Node {
 public:
  void tick() {
    image_.data.clear();
    image_.data.resize(100);
    uint8_t* const begin = image_.data.data();
    uint8_t* const brightest = std::max_element(begin, begin + 100);
    image_.width = brightest - begin;
    image_.height = brightest - &image_.data[0] + (image_.data.data() + 100 - brightest);
    std::ostringstream text;
    text << reinterpret_cast<const char*>(begin);
    char line[200];
    snprintf(line, sizeof line, "%s", reinterpret_cast<const char*>(begin));
    image_.encoding = line + text.str();
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
};
//--- expected
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:28 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::sensor_msgs::Image image_;
