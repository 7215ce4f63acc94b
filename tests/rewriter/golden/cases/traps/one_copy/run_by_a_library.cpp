// What a library that is not known was given, what ends, and a function that calls what others added, write to what was
// published, which is let go afterwards.
#include <algorithm>
#include <functional>
#include <future>
#include <memory>
#include <vector>

#include <other/library.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    polled_ = nh.advertise<sensor_msgs::Image>("polled", 1);
    released_ = nh.advertise<sensor_msgs::Image>("released", 1);
    notified_ = nh.advertise<sensor_msgs::Image>("notified", 1);
    sorted_ = nh.advertise<sensor_msgs::Image>("sorted", 1);
    other::post([this] {
      if (!first_.data.empty()) first_.data[0] = 1;
      if (!fourth_.data.empty()) fourth_.data[0] = 1;
    });
    changes_.push_back([this] {
      if (!third_.data.empty()) third_.data[0] = 1;
    });
  }
  void polled() {
    first_.data.assign(100, 1);
    polled_.publish(first_);
    other::poll();
    first_.data.clear();
  }
  void released() {
    second_.data.assign(100, 1);
    {
      const std::shared_ptr<void> at_end(nullptr, [this](void*) { second_.data[0] = 1; });
      released_.publish(second_);
    }
    second_.data.clear();
  }
  void notified() {
    third_.data.assign(100, 1);
    notified_.publish(third_);
    notify();
    third_.data.clear();
  }
  void sorted() {
    fourth_.data.assign(100, 1);
    sorted_.publish(fourth_);
    std::sort(order_.begin(), order_.end());
    fourth_.data.clear();
  }

 private:
  void notify() {
    for (const std::function<void()>& change : changes_) change();
  }

  ros::Publisher polled_, released_, notified_, sorted_;
  sensor_msgs::Image first_, second_, third_, fourth_;
  std::vector<std::function<void()>> changes_;
  std::vector<int> order_;
};
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'polled'
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'released'
// advertise src/node.cpp:18 sensor_msgs/Image one_copy 'notified'
// advertise src/node.cpp:19 sensor_msgs/Image zero_copy 'sorted'
// publish src/node.cpp:30 sensor_msgs/Image one_copy 'polled' TZC1022 line 21 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:38 sensor_msgs/Image one_copy 'released' TZC1022 line 37 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:44 sensor_msgs/Image one_copy 'notified' TZC1022 line 25 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:50 sensor_msgs/Image zero_copy 'sorted'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    polled_ = nh.advertise<sensor_msgs::Image>("polled", 1);
// -    released_ = nh.advertise<sensor_msgs::Image>("released", 1);
// -    notified_ = nh.advertise<sensor_msgs::Image>("notified", 1);
// -    sorted_ = nh.advertise<sensor_msgs::Image>("sorted", 1);
// +    polled_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "polled", 1);
// +    released_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "released", 1);
// +    notified_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "notified", 1);
// +    sorted_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "sorted", 1);
// -  ros::Publisher polled_, released_, notified_, sorted_;
// -  sensor_msgs::Image first_, second_, third_, fourth_;
// +  tzc::Publisher polled_, released_, notified_, sorted_;
// +  tzc::sensor_msgs::Image first_, second_, third_, fourth_;
