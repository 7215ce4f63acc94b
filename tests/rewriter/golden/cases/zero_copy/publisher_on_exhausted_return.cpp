// --on-exhausted=return.
//RUN: on-exhausted=return
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish(bool twice) {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
    image->data.resize(1);
    pub_.publish(image);
    if (twice) pub_.publish(image);
  }
  bool publish() {
    sensor_msgs::Image image;
    image.data.resize(1);
    pub_.publish(image);
    return true;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +    tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*image);
// +    if (!pub_.allocate(*image)) return;
// -    if (twice) pub_.publish(image);
// +    if (twice) { if (pub_.allocate(*image)) pub_.publish(image); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    pub_.publish(image);
// +    if (pub_.allocate(image)) pub_.publish(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
