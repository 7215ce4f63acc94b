// The caller of the function that advertises holds the lock.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

class Node {
 public:
  void restart(const std::string& topic) {
    std::lock_guard<std::mutex> lock(mutex_);
    advertise(topic);
  }
  void fill() {
    image_ = boost::make_shared<sensor_msgs::Image>();
    image_->data.resize(100);
  }
  void publish() {
    std::lock_guard<std::mutex> lock(mutex_);
    send();
  }

 private:
  void advertise(const std::string& topic) { pub_ = nh_.advertise<sensor_msgs::Image>(topic, 1); }
  void send() { pub_.publish(image_); }

  ros::NodeHandle nh_;
  std::mutex mutex_;
  ros::Publisher pub_;
  sensor_msgs::ImagePtr image_;
};
//--- expected
// advertise src/node.cpp:23 sensor_msgs/Image zero_copy
// publish src/node.cpp:24 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    image_ = boost::make_shared<sensor_msgs::Image>();
// +    image_ = boost::make_shared<tzc::sensor_msgs::Image>();
// +    tzc::allocate(*image_);
// -  void advertise(const std::string& topic) { pub_ = nh_.advertise<sensor_msgs::Image>(topic, 1); }
// +  void advertise(const std::string& topic) { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, topic, 1); }
// -  ros::Publisher pub_;
// -  sensor_msgs::ImagePtr image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::ImagePtr image_;
