// Another thread advertises anew, and the publisher is looked at under a lock.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

class Node {
 public:
  void advertise(const std::string& topic) {
    std::lock_guard<std::mutex> lock(mutex_);
    pub_ = nh_.advertise<sensor_msgs::Image>(topic, 1);
  }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::lock_guard<std::mutex> lock(mutex_);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  std::mutex mutex_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy
// publish src/node.cpp:17 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>(topic, 1);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, topic, 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
