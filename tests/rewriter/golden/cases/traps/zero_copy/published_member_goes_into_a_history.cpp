// A member is filled and published under another name, which binds its array to shared memory; what a history keeps of it and
// publishes again lies there, too.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <deque>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
  void onTimer(const ros::TimerEvent&) {
    image_.data.resize(40000);
    for (int i = 0; i < 40000; ++i) image_.data[i] = static_cast<unsigned char>(i);
    send(image_);
    history_.push_back(image_);
  }
  void again() {
    for (const sensor_msgs::Image& image : history_) pub_.publish(image);
    history_.clear();
  }

 private:
  void send(const sensor_msgs::Image& image) { pub_.publish(image); }

  ros::Publisher pub_;
  sensor_msgs::Image image_;
  std::deque<sensor_msgs::Image> history_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1)) {}
// -    image_.data.resize(40000);
// +    image_.data.resize(40000, tzc::uninitialized);
// -    for (const sensor_msgs::Image& image : history_) pub_.publish(image);
// +    for (const tzc::sensor_msgs::Image& image : history_) pub_.publish(image);
// -  void send(const sensor_msgs::Image& image) { pub_.publish(image); }
// +  void send(const tzc::sensor_msgs::Image& image) { pub_.publish(image); }
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// -  std::deque<sensor_msgs::Image> history_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
// +  std::deque<tzc::sensor_msgs::Image> history_;
