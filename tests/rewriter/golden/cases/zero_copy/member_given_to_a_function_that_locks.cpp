// The publisher is handed on by reference and looked at under the lock only.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

class Node {
 public:
  void restart(const std::string& topic) {
    std::lock_guard<std::mutex> lock(mutex_);
    pub_ = nh_.advertise<sensor_msgs::Image>(topic, 1);
  }
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    send(pub_, image);
  }

 private:
  void send(ros::Publisher& pub, sensor_msgs::Image& image) {
    std::lock_guard<std::mutex> lock(mutex_);
    pub.publish(image);
  }

  ros::NodeHandle nh_;
  std::mutex mutex_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy
// publish src/node.cpp:22 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>(topic, 1);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, topic, 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  void send(ros::Publisher& pub, sensor_msgs::Image& image) {
// +  void send(tzc::Publisher& pub, tzc::sensor_msgs::Image& image) {
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
