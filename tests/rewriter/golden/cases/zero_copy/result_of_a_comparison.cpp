// What GoogleTest gives as the result of a comparison has a text of its own, and refers to nothing.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
  void tick() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
    image->data.resize(40000);
    const testing::AssertionResult result = testing::internal::CmpHelperLT("", "", image->data[0], 7);
    pub_.publish(image);
    if (!result) testing::internal::report(result.failure_message());
  }

 private:
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1)) {}
// -    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +    tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
