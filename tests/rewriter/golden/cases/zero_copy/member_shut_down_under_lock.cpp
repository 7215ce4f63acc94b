// Another thread ends the publisher.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

class Node {
 public:
  Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
  void close() {
    std::lock_guard<std::mutex> lock(mutex_);
    pub_.shutdown();
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
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
// +  Node() : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
