// One source for two versions of ROS. What is not compiled here defines the same class again, or is the other branch of the same
// conditional: the two are never compiled together, so it names members of its own.
#ifndef USE_ROS2
#define USE_ROS1
#endif

#ifdef USE_ROS2
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/image.hpp>
using Image = sensor_msgs::msg::Image;
#else
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
using Image = sensor_msgs::Image;
#endif

#ifdef USE_ROS1
namespace driver {
class Output {
 public:
  explicit Output(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
  void send() {
    sensor_msgs::Image image;
    fill(image);
    pub_.publish(image);
  }

 private:
  void fill(sensor_msgs::Image& image) { image.data.resize(100); }
  ros::Publisher pub_;
};
}  // namespace driver
#endif

#ifdef USE_ROS2
namespace driver {
class Output {
 public:
  explicit Output(rclcpp::Node& node) : pub_(node.create_publisher<Image>("image", 1)) {}
  void send() {
    Image image;
    fill(image);
    pub_->publish(image);
  }

 private:
  void fill(Image& image) { image.data.resize(100); }
  rclcpp::Publisher<Image>::SharedPtr pub_;
};
}  // namespace driver
#endif
//--- expected
// advertise src/node.cpp:21 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:25 sensor_msgs/Image zero_copy 'image'
// note src/node.cpp:35 TZC3002
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Output(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
// +  explicit Output(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  void fill(sensor_msgs::Image& image) { image.data.resize(100); }
// -  ros::Publisher pub_;
// +  void fill(tzc::sensor_msgs::Image& image) { image.data.resize(100); }
// +  tzc::Publisher pub_;
