// The constructor starts the thread first, which waits until a function that the constructor calls tells it that all is there.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <atomic>
#include <thread>

class Node {
 public:
  Node() {
    thread_ = std::thread(&Node::run, this);
    set_up();
  }

 private:
  void set_up() {
    pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
    tell();
  }
  void tell() { is_ready_ = true; }
  void run() {
    sensor_msgs::Image image;
    image.data.resize(100);
    while (!is_ready_) std::this_thread::yield();
    pub_.publish(image);
  }

  ros::NodeHandle nh_;
  std::thread thread_;
  std::atomic<bool> is_ready_{false};
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:25 sensor_msgs/Image zero_copy 'image'
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
