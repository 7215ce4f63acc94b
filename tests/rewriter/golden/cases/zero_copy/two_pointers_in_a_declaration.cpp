// The second pointer has nothing to do with the first one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void tick(int n) {
    sensor_msgs::ImagePtr left(new sensor_msgs::Image), right(new sensor_msgs::Image);
    left->data.resize(n);
    right->data.resize(n);
    left_pub_.publish(left);
    right_pub_.publish(right);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher left_pub_ = nh_.advertise<sensor_msgs::Image>("left", 1);
  ros::Publisher right_pub_ = nh_.advertise<sensor_msgs::Image>("right", 1);
};
//--- expected
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'left'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'right'
// advertise src/node.cpp:17 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:18 sensor_msgs/Image zero_copy 'right'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::ImagePtr left(new sensor_msgs::Image), right(new sensor_msgs::Image);
// +    tzc::sensor_msgs::ImagePtr left(new tzc::sensor_msgs::Image), right(new tzc::sensor_msgs::Image);
// +    left_pub_.allocate(*left);
// +    right_pub_.allocate(*right);
// -  ros::Publisher left_pub_ = nh_.advertise<sensor_msgs::Image>("left", 1);
// -  ros::Publisher right_pub_ = nh_.advertise<sensor_msgs::Image>("right", 1);
// +  tzc::Publisher left_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "left", 1);
// +  tzc::Publisher right_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "right", 1);
