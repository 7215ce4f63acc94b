// A publisher with an initializer in the class.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void send() {
    sensor_msgs::Image image;
    image.data.resize(100);
    pub_.publish(image);
  }
 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10);
