// A publisher is kept in an object whose type does not tell, and taken out by its own.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <any>
#include <map>
#include <string>

class Kept {
 public:
  explicit Kept(ros::NodeHandle& nh) { kept_ = nh.advertise<sensor_msgs::Image>("kept", 1); }
  void tick(const sensor_msgs::Image& image) { std::any_cast<ros::Publisher&>(kept_).publish(image); }

 private:
  std::any kept_;
};

class Registry {
 public:
  explicit Registry(ros::NodeHandle& nh) { put("out", nh.advertise<sensor_msgs::Image>("registered", 1)); }
  template <class T>
  void put(const std::string& name, T value) {
    values_[name] = std::move(value);
  }

 private:
  std::map<std::string, std::any> values_;
};

class Asked {
 public:
  explicit Asked(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("asked", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(sizeof(pub_));
    pub_.publish(image);
  }

 private:
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image plain 'kept' TZC1010 it becomes part of 'kept_', whose type does not tell
// publish src/node.cpp:12 sensor_msgs/Image one_copy TZC1017 the publisher is not one of the package
// advertise src/node.cpp:20 sensor_msgs/Image plain 'registered' TZC1010 it becomes part of 'values_[name]', whose type does not tell
// advertise src/node.cpp:32 sensor_msgs/Image plain 'asked' TZC1010 the program asks for its type
// publish src/node.cpp:36 sensor_msgs/Image plain 'asked' TZC1010 the program asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  void tick(const sensor_msgs::Image& image) { std::any_cast<ros::Publisher&>(kept_).publish(image); }
// +  void tick(const sensor_msgs::Image& image) { tzc::publish(std::any_cast<ros::Publisher&>(kept_), image); }
