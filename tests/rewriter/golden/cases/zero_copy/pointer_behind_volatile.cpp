// Another thread sets the pointer, and says so by a volatile flag.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void start(ros::Publisher* pub) {
    *pub = nh_.advertise<sensor_msgs::Image>("image", 10);
    pub_ = pub;
    ready_ = true;
  }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(100);
    while (!ready_) {
    }
    pub_->publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher* pub_ = nullptr;
  volatile bool ready_ = false;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  void start(ros::Publisher* pub) {
// -    *pub = nh_.advertise<sensor_msgs::Image>("image", 10);
// +  void start(tzc::Publisher* pub) {
// +    *pub = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  ros::Publisher* pub_ = nullptr;
// +  tzc::Publisher* pub_ = nullptr;
