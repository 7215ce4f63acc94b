// Containers of the package's classes are made of the elements of messages: what their functions take by reference is no element.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

static void change(int) {}

struct Config {
  Config(const char* given, const std::vector<std::string>& list) : name(given), parts(list) {}
  std::string name;
  std::vector<std::string> parts;
};
struct Reading {
  Reading(uint8_t number) : value(number) {}
  Reading(const Config& config, uint8_t number) : value(number), scale(config.name.size()) {}
  Reading(const char* text, const std::shared_ptr<Config>& config) : scale(config ? text[0] : 0) {}
  Reading(const ros::Time& time, float offset) : scale(time.toSec() > offset ? 1 : 2) {}
  bool operator==(const Config& config) const { return config.name.empty(); }
  Reading& operator+=(const double& more) {
    value = static_cast<uint8_t>(value + more);
    return *this;
  }
  uint8_t value = 0;
  std::size_t scale = 1;
};

void made_of_elements(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("made_of_elements", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::vector<Reading> readings;
  readings.assign(image.data.begin(), image.data.end());
  pub.publish(image);
  change(1);
}
void inserted(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("inserted", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::vector<Reading> readings;
  readings.insert(readings.end(), image.data.begin(), image.data.end());
  std::vector<Reading> more(image.data.begin(), image.data.end());
  pub.publish(image);
  change(1);
}
//--- expected
// advertise src/node.cpp:34 sensor_msgs/Image zero_copy 'made_of_elements'
// publish src/node.cpp:39 sensor_msgs/Image zero_copy 'made_of_elements'
// advertise src/node.cpp:43 sensor_msgs/Image zero_copy 'inserted'
// publish src/node.cpp:49 sensor_msgs/Image zero_copy 'inserted'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("made_of_elements", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "made_of_elements", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("inserted", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "inserted", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
