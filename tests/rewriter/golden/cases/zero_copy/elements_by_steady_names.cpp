// Elements that are filled and published by one name that keeps its meaning: an index of a loop, a reference to a slot, a key.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

class Node {
 public:
  Node() : frames_(2) {
    loop_pub_ = nh_.advertise<sensor_msgs::Image>("a", 1);
    slot_pub_ = nh_.advertise<sensor_msgs::Image>("b", 1);
    key_pub_ = nh_.advertise<sensor_msgs::Image>("c", 1);
    pair_pub_ = nh_.advertise<sensor_msgs::Image>("d", 1);
  }
  void by_loop(int k) {
    for (size_t i = 0; i < frames_.size(); ++i) {
      frames_[i].data.clear();
      frames_[i].data.push_back(k);
      loop_pub_.publish(frames_[i]);
    }
  }
  void by_slot(int k) {
    sensor_msgs::Image& frame = slots_[slot_];
    frame.data.clear();
    frame.data.push_back(k);
    slot_pub_.publish(frame);
    slot_ = 1 - slot_;
  }
  void by_key(int camera, int k) {
    by_key_[camera].data.clear();
    by_key_[camera].data.push_back(k);
    key_pub_.publish(by_key_[camera]);
  }
  void by_pair(int k) {
    both_.first.data.clear();
    both_.first.data.push_back(k);
    pair_pub_.publish(both_.first);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher loop_pub_, slot_pub_, key_pub_, pair_pub_;
  std::vector<sensor_msgs::Image> frames_;
  sensor_msgs::Image slots_[2];
  std::map<int, sensor_msgs::Image> by_key_;
  std::pair<sensor_msgs::Image, sensor_msgs::Image> both_;
  int slot_ = 0;
};
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'a'
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'b'
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'c'
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'd'
// publish src/node.cpp:22 sensor_msgs/Image zero_copy 'a'
// publish src/node.cpp:29 sensor_msgs/Image zero_copy 'b'
// publish src/node.cpp:35 sensor_msgs/Image zero_copy 'c'
// publish src/node.cpp:40 sensor_msgs/Image zero_copy 'd'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    loop_pub_ = nh_.advertise<sensor_msgs::Image>("a", 1);
// -    slot_pub_ = nh_.advertise<sensor_msgs::Image>("b", 1);
// -    key_pub_ = nh_.advertise<sensor_msgs::Image>("c", 1);
// -    pair_pub_ = nh_.advertise<sensor_msgs::Image>("d", 1);
// +    loop_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "a", 1);
// +    slot_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "b", 1);
// +    key_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "c", 1);
// +    pair_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "d", 1);
// -    sensor_msgs::Image& frame = slots_[slot_];
// +    tzc::sensor_msgs::Image& frame = slots_[slot_];
// -  ros::Publisher loop_pub_, slot_pub_, key_pub_, pair_pub_;
// -  std::vector<sensor_msgs::Image> frames_;
// -  sensor_msgs::Image slots_[2];
// -  std::map<int, sensor_msgs::Image> by_key_;
// -  std::pair<sensor_msgs::Image, sensor_msgs::Image> both_;
// +  tzc::Publisher loop_pub_, slot_pub_, key_pub_, pair_pub_;
// +  std::vector<tzc::sensor_msgs::Image> frames_;
// +  tzc::sensor_msgs::Image slots_[2];
// +  std::map<int, tzc::sensor_msgs::Image> by_key_;
// +  std::pair<tzc::sensor_msgs::Image, tzc::sensor_msgs::Image> both_;
