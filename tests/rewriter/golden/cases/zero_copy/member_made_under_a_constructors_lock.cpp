// The constructor starts the thread first, and advertises under the lock that the thread waits for.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>
#include <thread>

class Node {
 public:
  Node() {
    thread_ = std::thread(&Node::run, this);
    std::lock_guard<std::mutex> lock(mutex_);
    pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  }

 private:
  void run() {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::lock_guard<std::mutex> lock(mutex_);
    if (pub_) pub_.publish(image);
  }

  ros::NodeHandle nh_;
  std::thread thread_;
  std::mutex mutex_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:21 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
