// The message is built in a function that holds no lock; the publisher is changed and looked at under one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

class Node {
 public:
  void advertise(const std::string& topic) {
    std::lock_guard<std::mutex> lock(mutex_);
    pub_ = nh_.advertise<sensor_msgs::Image>(topic, 1);
  }
  void fill() {
    image_ = boost::make_shared<sensor_msgs::Image>();
    image_->data.resize(100);
  }
  void publish() {
    std::lock_guard<std::mutex> lock(mutex_);
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  std::mutex mutex_;
  ros::Publisher pub_;
  sensor_msgs::ImagePtr image_;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy
// publish src/node.cpp:19 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>(topic, 1);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, topic, 1);
// -    image_ = boost::make_shared<sensor_msgs::Image>();
// +    image_ = boost::make_shared<tzc::sensor_msgs::Image>();
// +    tzc::allocate(*image_);
// -  ros::Publisher pub_;
// -  sensor_msgs::ImagePtr image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::ImagePtr image_;
