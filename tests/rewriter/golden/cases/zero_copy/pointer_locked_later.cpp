// Another thread opens and closes the publisher, and the pointer to it is looked at under a lock.
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
    sensor_msgs::Image image;
    image.data.resize(100);
    std::lock_guard<std::mutex> lock(mutex_);
    if (pub_) pub_->publish(image);
  }
  void publish_if_wanted() {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      if (!pub_) return;
    }
    sensor_msgs::Image image;
    image.data.resize(100);
    mutex_.lock();
    if (pub_) pub_->publish(image);
    mutex_.unlock();
  }

 private:
  ros::NodeHandle nh_;
  std::mutex mutex_;
  boost::shared_ptr<ros::Publisher> pub_;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:28 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    if (wanted) pub_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("image", 1)));
// +    if (wanted) pub_.reset(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  boost::shared_ptr<ros::Publisher> pub_;
// +  boost::shared_ptr<tzc::Publisher> pub_;
