// The lock that guards the pointer to the publisher is held where the message is born; or the pointer is a copy.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

class Node {
 public:
  void open(bool wanted) {
    std::lock_guard<std::mutex> lock(mutex_);
    pub_.reset();
    if (wanted) pub_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("image", 1)));
  }
  void publish() {
    std::lock_guard<std::mutex> lock(mutex_);
    sensor_msgs::Image image;
    image.data.resize(100);
    if (pub_) pub_->publish(image);
  }
  void publish_copy(boost::shared_ptr<ros::Publisher> pub) {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::lock_guard<std::mutex> lock(mutex_);
    if (pub) pub->publish(image);
  }
  void copy() { publish_copy(pub_); }

 private:
  ros::NodeHandle nh_;
  std::mutex mutex_;
  boost::shared_ptr<ros::Publisher> pub_;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    if (wanted) pub_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("image", 1)));
// +    if (wanted) pub_.reset(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    if (pub_) pub_->allocate(image);
// -  void publish_copy(boost::shared_ptr<ros::Publisher> pub) {
// -    sensor_msgs::Image image;
// +  void publish_copy(boost::shared_ptr<tzc::Publisher> pub) {
// +    tzc::sensor_msgs::Image image;
// +    if (pub) pub->allocate(image);
// -  boost::shared_ptr<ros::Publisher> pub_;
// +  boost::shared_ptr<tzc::Publisher> pub_;
