// Members that are published under another name, or whose copy goes to where the target has its elements.
#include <map>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Passed {
 public:
  explicit Passed(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("passed", 1)) {}
  void step(int k) {
    frame_.data.assign(5000, k);
    send(frame_);
  }
  void send(const sensor_msgs::Image& image) { pub_.publish(image); }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image frame_;
};

class Copied {
 public:
  explicit Copied(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("copied", 1)) {}
  void fill(int k) {
    frame_.data.assign(5000, k);
    frames_[k % 2] = frame_;
  }
  void send() {
    for (auto& one : frames_) pub_.publish(one.second);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image frame_;
  std::map<int, sensor_msgs::Image> frames_;
};

void run(ros::NodeHandle& nh) {
  Passed passed(nh);
  Copied copied(nh);
  for (int k = 0; ros::ok(); ++k) {
    passed.step(k);
    copied.fill(k);
    copied.send();
  }
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'passed'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'passed'
// advertise src/node.cpp:23 sensor_msgs/Image zero_copy 'copied'
// publish src/node.cpp:29 sensor_msgs/Image zero_copy 'copied'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Passed(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("passed", 1)) {}
// +  explicit Passed(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "passed", 1)) {}
// -  void send(const sensor_msgs::Image& image) { pub_.publish(image); }
// +  void send(const tzc::sensor_msgs::Image& image) { pub_.publish(image); }
// -  ros::Publisher pub_;
// -  sensor_msgs::Image frame_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image frame_;
// -  explicit Copied(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("copied", 1)) {}
// +  explicit Copied(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "copied", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  std::map<int, sensor_msgs::Image> frames_;
// +  std::map<int, tzc::sensor_msgs::Image> frames_;
