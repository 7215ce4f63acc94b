// What stands before the pointer throws nothing but for want of memory: sizes that their types bound, positions that each text has, times that
// are asked or compared, texts of the function's own.
#include <algorithm>
#include <cmath>
#include <memory>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sstream>
#include <vector>

class Node {
 public:
  Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
  void select() { current_ = &pub_; }

  void by_size(const sensor_msgs::Image& in) {
    sensor_msgs::Image image;
    image.data.resize(in.height * in.step);
    current_->publish(image);
  }
  void by_size_of_another(const sensor_msgs::Image& in) {
    sensor_msgs::Image image;
    image.data.resize(in.data.size() * 3 / 2);
    current_->publish(image);
  }
  void by_bytes(unsigned char high, unsigned char low) {
    sensor_msgs::Image image;
    image.data.resize(high * 256 + low);
    current_->publish(image);
  }
  void by_choice(bool large) {
    sensor_msgs::Image image;
    image.data.resize(large ? 640 * 480 : 320 * 240);
    current_->publish(image);
  }
  void by_texts(const std::string& name) {
    sensor_msgs::Image image;
    image.data.resize(101);
    image.header.frame_id = "camera_" + name.substr(0, 4) + std::to_string(image.width);
    if (name.empty()) image.header.frame_id.insert(0, "/");
    current_->publish(image);
  }
  void by_stream(int n) {
    sensor_msgs::Image image;
    image.data.resize(102);
    std::ostringstream text;
    text << "camera_" << n;
    image.header.frame_id = text.str();
    current_->publish(image);
  }
  void by_time(const ros::Time& last) {
    sensor_msgs::Image image;
    image.data.resize(103);
    image.header.stamp = ros::Time::now();
    if (image.header.stamp < last) image.header.stamp = ros::Time(0);
    ROS_INFO("image %u", image.width);
    ROS_WARN_STREAM("at " << image.header.stamp.toSec());
    current_->publish(image);
  }
  void by_numbers(std::vector<double> values) {
    sensor_msgs::Image image;
    image.data.resize(104);
    std::sort(values.begin(), values.end(), [](double a, double b) { return a > b; });
    image.width = std::max(std::floor(std::sqrt(values.size())), 1.0);
    std::vector<double> sums;
    sums.push_back(values.size());
    current_->publish(image);
  }
  void by_made_pointer() {
    auto pub = std::make_shared<ros::Publisher>(pub_);
    sensor_msgs::Image image;
    image.data.resize(105);
    ros::spinOnce();
    pub->publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Publisher* current_ = nullptr;
};
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:29 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:34 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:41 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:49 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:58 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:67 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:74 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
// +  Node() : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    current_->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    current_->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    current_->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    current_->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    current_->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    current_->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    auto pub = std::make_shared<ros::Publisher>(pub_);
// -    sensor_msgs::Image image;
// +    auto pub = std::make_shared<tzc::Publisher>(pub_);
// +    tzc::sensor_msgs::Image image;
// +    pub->allocate(image);
// -  ros::Publisher pub_;
// -  ros::Publisher* current_ = nullptr;
// +  tzc::Publisher pub_;
// +  tzc::Publisher* current_ = nullptr;
