// Messages that last, filled and published through iterators, choices, functions and pointers that may lead to either.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <map>
#include <vector>

class Node {
 public:
  Node() : frames_(2) {
    pub_ = nh_.advertise<sensor_msgs::Image>("a", 1);
    choice_pub_ = nh_.advertise<sensor_msgs::Image>("b", 1);
    got_pub_ = nh_.advertise<sensor_msgs::Image>("c", 1);
    map_pub_ = nh_.advertise<sensor_msgs::Image>("d", 1);
    pointer_pub_ = nh_.advertise<sensor_msgs::Image>("e", 1);
    deep_pub_ = nh_.advertise<sensor_msgs::Image>("f", 1);
  }
  void by_iterator() {
    auto it = frames_.begin() + n_++ % 2;
    it->data.resize(100);
    it->data[0] = n_;
    pub_.publish(*it);
  }
  void by_choice() {
    even_.data.resize(100);
    odd_.data.resize(100);
    even_.data[0] = odd_.data[0] = n_;
    choice_pub_.publish(n_++ % 2 ? odd_ : even_);
  }
  sensor_msgs::Image& current() {
    if (n_ % 2) return first_;
    return second_;
  }
  void by_function() {
    sensor_msgs::Image& image = current();
    image.data.resize(100);
    image.data[0] = n_++;
    got_pub_.publish(current());
  }
  void by_map(int key) {
    auto found = by_key_.find(key);
    if (found == by_key_.end()) return;
    found->second.data.resize(100);
    found->second.data[0] = n_++;
    map_pub_.publish(found->second);
  }
  void by_pointer() {
    sensor_msgs::Image* at = &others_[0];
    if (n_++ % 2) at = &others_[1];
    at->data.resize(100);
    at->data[0] = n_;
    pointer_pub_.publish(*at);
  }
  void filled_elsewhere() {
    deep_.data.resize(100);
    fill(n_ % 2 ? &deep_ : nullptr);
    deep_pub_.publish(deep_);
  }
  void fill(sensor_msgs::Image* image) {
    if (image) image->data[0] = n_++;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_, choice_pub_, got_pub_, map_pub_, pointer_pub_, deep_pub_;
  std::vector<sensor_msgs::Image> frames_;
  std::map<int, sensor_msgs::Image> by_key_;
  sensor_msgs::Image even_, odd_, first_, second_, others_[2], deep_;
  int n_ = 0;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'a'
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'b'
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'c'
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'd'
// advertise src/node.cpp:15 sensor_msgs/Image one_copy 'e'
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'f'
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'a' TZC1022 line 21 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:28 sensor_msgs/Image one_copy 'b' TZC1022 line 27 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:38 sensor_msgs/Image one_copy 'c' TZC1022 line 37 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:45 sensor_msgs/Image one_copy 'd' TZC1022 line 44 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:52 sensor_msgs/Image one_copy 'e' TZC1022 line 51 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:57 sensor_msgs/Image one_copy 'f' TZC1022 line 60 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>("a", 1);
// -    choice_pub_ = nh_.advertise<sensor_msgs::Image>("b", 1);
// -    got_pub_ = nh_.advertise<sensor_msgs::Image>("c", 1);
// -    map_pub_ = nh_.advertise<sensor_msgs::Image>("d", 1);
// -    pointer_pub_ = nh_.advertise<sensor_msgs::Image>("e", 1);
// -    deep_pub_ = nh_.advertise<sensor_msgs::Image>("f", 1);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "a", 1);
// +    choice_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "b", 1);
// +    got_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "c", 1);
// +    map_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "d", 1);
// +    pointer_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "e", 1);
// +    deep_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "f", 1);
// -  sensor_msgs::Image& current() {
// +  tzc::sensor_msgs::Image& current() {
// -    sensor_msgs::Image& image = current();
// +    tzc::sensor_msgs::Image& image = current();
// -    sensor_msgs::Image* at = &others_[0];
// +    tzc::sensor_msgs::Image* at = &others_[0];
// -  void fill(sensor_msgs::Image* image) {
// +  void fill(tzc::sensor_msgs::Image* image) {
// -  ros::Publisher pub_, choice_pub_, got_pub_, map_pub_, pointer_pub_, deep_pub_;
// -  std::vector<sensor_msgs::Image> frames_;
// -  std::map<int, sensor_msgs::Image> by_key_;
// -  sensor_msgs::Image even_, odd_, first_, second_, others_[2], deep_;
// +  tzc::Publisher pub_, choice_pub_, got_pub_, map_pub_, pointer_pub_, deep_pub_;
// +  std::vector<tzc::sensor_msgs::Image> frames_;
// +  std::map<int, tzc::sensor_msgs::Image> by_key_;
// +  tzc::sensor_msgs::Image even_, odd_, first_, second_, others_[2], deep_;
