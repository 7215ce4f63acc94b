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
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'kept' TZC1010 it becomes part of 'kept_', whose type does not tell
// publish src/node.cpp:12 sensor_msgs/Image one_copy TZC1019 no call that gives 'image' a message was found
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'registered' TZC1010 it becomes part of 'values_[name]', whose type does not tell
// advertise src/node.cpp:32 sensor_msgs/Image zero_copy 'asked'
// publish src/node.cpp:36 sensor_msgs/Image zero_copy 'asked'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Kept(ros::NodeHandle& nh) { kept_ = nh.advertise<sensor_msgs::Image>("kept", 1); }
// -  void tick(const sensor_msgs::Image& image) { std::any_cast<ros::Publisher&>(kept_).publish(image); }
// +  explicit Kept(ros::NodeHandle& nh) { kept_ = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("kept", 1)); }
// +  void tick(const sensor_msgs::Image& image) { tzc::publish(std::any_cast<ros::Publisher&>(kept_), image); }
// -  explicit Registry(ros::NodeHandle& nh) { put("out", nh.advertise<sensor_msgs::Image>("registered", 1)); }
// +  explicit Registry(ros::NodeHandle& nh) { put("out", tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("registered", 1))); }
// -  explicit Asked(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("asked", 1)) {}
// +  explicit Asked(ros::NodeHandle& nh) : pub_(tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("asked", 1))) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    pub_.publish(image);
// +    tzc::publish(pub_, image);
