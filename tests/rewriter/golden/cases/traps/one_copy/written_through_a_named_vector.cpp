// A message that lasts is written through another name of its array after each publish: that copies.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void step() {
    std::vector<uint8_t>& bytes = frame_.data;
    bytes[0] = 1;
    pub_.publish(frame_);
    std::vector<uint8_t>* same = &frame_.data;
    (*same)[1] = 2;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image frame_;
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1022 line 11 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    std::vector<uint8_t>& bytes = frame_.data;
// +    auto& bytes = frame_.data;
// -    std::vector<uint8_t>* same = &frame_.data;
// +    auto* same = &frame_.data;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image frame_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::sensor_msgs::Image frame_;
