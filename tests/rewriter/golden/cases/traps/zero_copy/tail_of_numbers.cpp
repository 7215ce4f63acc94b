// Somebody keeps a pointer into the image; what follows the publish only calculates.
#include <angles/angles.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cmath>

void library(uint8_t* pixels);

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(100);
    library(&image.data[0]);
    pub_.publish(image);
    angle_ = angles::normalize_angle(angle_ + angles::from_degrees(3));
    height_ = std::sqrt(angle_) + std::floor(sin(angle_));
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  double angle_ = 0, height_ = 0;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
