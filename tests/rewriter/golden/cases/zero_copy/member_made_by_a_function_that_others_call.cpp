// The function that advertises runs again when parameters change, while another thread publishes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

class Node {
 public:
  Node() { set_up(); }
  void reset() {
    std::lock_guard<std::mutex> lock(mutex_);
    set_up();
  }
  void run() {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::lock_guard<std::mutex> lock(mutex_);
    pub_.publish(image);
  }

 private:
  void set_up() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }

  ros::NodeHandle nh_;
  std::mutex mutex_;
  ros::Publisher pub_;
};
//--- expected
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:22 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  void set_up() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// +  void set_up() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
