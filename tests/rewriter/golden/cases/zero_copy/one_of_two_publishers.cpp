// A choice of publishers: both are ported, since either may send the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    left_pub_ = nh.advertise<sensor_msgs::Image>("left", 1);
    right_pub_ = nh.advertise<sensor_msgs::Image>("right", 1);
  }
  void send(bool is_left) {
    sensor_msgs::Image image;
    image.data.resize(640 * 480);
    (is_left ? left_pub_ : right_pub_).publish(image);
  }

 private:
  ros::Publisher left_pub_, right_pub_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'right'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    left_pub_ = nh.advertise<sensor_msgs::Image>("left", 1);
// -    right_pub_ = nh.advertise<sensor_msgs::Image>("right", 1);
// +    left_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "left", 1);
// +    right_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "right", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    (is_left ? left_pub_ : right_pub_).allocate(image);
// -  ros::Publisher left_pub_, right_pub_;
// +  tzc::Publisher left_pub_, right_pub_;
