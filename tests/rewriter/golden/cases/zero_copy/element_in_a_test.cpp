// A test of the package compares elements of a message: GoogleTest keeps no reference to them.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
  void tick() {
    sensor_msgs::ImagePtr image = make();
    pub_.publish(image);
  }
  sensor_msgs::ImagePtr make() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
    image->data.resize(40000);
    return image;
  }

 private:
  ros::Publisher pub_;
};

void test(Node& node) {
  const sensor_msgs::ImageConstPtr image = node.make();
  EXPECT_LT(image->data.at(0), 7);
  EXPECT_EQ(image->data[1], 0);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1)) {}
// -    sensor_msgs::ImagePtr image = make();
// +    tzc::sensor_msgs::ImagePtr image = make();
// -  sensor_msgs::ImagePtr make() {
// -    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +  tzc::sensor_msgs::ImagePtr make() {
// +    tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  const sensor_msgs::ImageConstPtr image = node.make();
// +  const tzc::sensor_msgs::ImageConstPtr image = node.make();
