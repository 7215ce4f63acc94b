// The count is the size, cast to a type that holds it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cstring>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish(const uint8_t* pixels, int count) {
    const int n = count;
    image_.data.resize(n);
    memcpy(&image_.data[0], pixels, static_cast<std::size_t>(n));
    pub_.publish(image_);
    image_.data.resize(unsigned(n));
    memcpy(&image_.data[0], pixels, n);
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -    image_.data.resize(n);
// +    image_.data.resize(n, tzc::uninitialized);
// -    image_.data.resize(unsigned(n));
// +    image_.data.resize(unsigned(n), tzc::uninitialized);
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
