// Members that are filled, but never published themselves: what gets their content by value was never allocated.
#include <deque>
#include <map>
#include <utility>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Queued {
 public:
  explicit Queued(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("queued", 1)) {}
  void fill(int k) {
    for (int i = 0; i < 5000; ++i) frame_.data.push_back(k);
    queue_.push_back(std::move(frame_));
  }
  void send() {
    pub_.publish(queue_.front());
    queue_.pop_front();
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image frame_;
  std::deque<sensor_msgs::Image> queue_;
};

class Moved {
 public:
  explicit Moved(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("moved", 1)) {}
  void fill(int k) {
    for (int i = 0; i < 5000; ++i) frame_.data.push_back(k);
    last_ = std::move(frame_);
  }
  void send() { pub_.publish(last_); }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image frame_, last_;
};

class Returned {
 public:
  explicit Returned(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("returned", 1)) {}
  sensor_msgs::Image fill(int k) {
    frame_.data.assign(5000, k);
    return frame_;
  }
  void send(int k) { pub_.publish(fill(k)); }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image frame_;
};

class InMap {
 public:
  explicit InMap(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("in_map", 1)) {}
  void fill(int k) {
    frame_.data.assign(5000, k);
    frames_.emplace(k, frame_);
  }
  void send() {
    for (auto& one : frames_) pub_.publish(one.second);
    frames_.clear();
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image frame_;
  std::map<int, sensor_msgs::Image> frames_;
};

void run(ros::NodeHandle& nh) {
  Queued queued(nh);
  Moved moved(nh);
  Returned returned(nh);
  InMap in_map(nh);
  for (int k = 0; ros::ok(); ++k) {
    queued.fill(k);
    queued.send();
    moved.fill(k);
    moved.send();
    returned.send(k);
    in_map.fill(k);
    in_map.send();
  }
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'queued'
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'queued' TZC1022 its elements come from a message that is never published itself (stored by 'push_back' in line 14), and lie outside shared memory
// advertise src/node.cpp:29 sensor_msgs/Image one_copy 'moved'
// publish src/node.cpp:34 sensor_msgs/Image one_copy 'moved' TZC1022 its elements come from a message that is never published itself (moved to 'last_' in line 32), and lie outside shared memory
// advertise src/node.cpp:43 sensor_msgs/Image one_copy 'returned'
// publish src/node.cpp:48 sensor_msgs/Image one_copy 'returned' TZC1022 its elements come from a message that is never published itself (returned from 'fill' in line 46), and lie outside shared memory
// advertise src/node.cpp:57 sensor_msgs/Image one_copy 'in_map'
// publish src/node.cpp:63 sensor_msgs/Image one_copy 'in_map' TZC1022 its elements come from a message that is never published itself (stored by 'emplace' in line 60), and lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Queued(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("queued", 1)) {}
// +  explicit Queued(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "queued", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::Image frame_;
// -  std::deque<sensor_msgs::Image> queue_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image frame_;
// +  std::deque<tzc::sensor_msgs::Image> queue_;
// -  explicit Moved(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("moved", 1)) {}
// +  explicit Moved(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "moved", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::Image frame_, last_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image frame_, last_;
// -  explicit Returned(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("returned", 1)) {}
// -  sensor_msgs::Image fill(int k) {
// +  explicit Returned(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "returned", 1)) {}
// +  tzc::sensor_msgs::Image fill(int k) {
// -  ros::Publisher pub_;
// -  sensor_msgs::Image frame_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image frame_;
// -  explicit InMap(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("in_map", 1)) {}
// +  explicit InMap(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "in_map", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::Image frame_;
// -  std::map<int, sensor_msgs::Image> frames_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image frame_;
// +  std::map<int, tzc::sensor_msgs::Image> frames_;
