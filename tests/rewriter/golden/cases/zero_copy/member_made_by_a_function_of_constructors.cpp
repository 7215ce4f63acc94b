// Constructors share a private function that advertises: nobody else has the object before it returns.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>
#include <thread>

class Node {
 public:
  Node() { set_up(); }
  explicit Node(const ros::NodeHandle& nh) : nh_(nh) { set_up(); }
  void start() { thread_ = std::thread(&Node::run, this); }

 private:
  void set_up() {
    count_ = 0;
    pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  }
  void run() {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::lock_guard<std::mutex> lock(mutex_);
    ++count_;
    pub_.publish(image);
  }

  ros::NodeHandle nh_;
  std::thread thread_;
  std::mutex mutex_;
  int count_ = 0;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
