// Names that lead to another message the next time: indices, iterators, ends of containers, parts of what functions return.
#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <deque>
#include <tuple>
#include <utility>
#include <vector>

void touch(std::deque<sensor_msgs::CompressedImage>& given, int n) {
  given[0].data[0] = n;
}

class Node {
 public:
  Node() : all_(2), queue_(2), given_(2) {
    part_pub_ = nh_.advertise<sensor_msgs::Image>("a", 1);
    pair_pub_ = nh_.advertise<sensor_msgs::Image>("b", 1);
    tuple_pub_ = nh_.advertise<sensor_msgs::Image>("c", 1);
    index_pub_ = nh_.advertise<sensor_msgs::Image>("d", 1);
    half_pub_ = nh_.advertise<sensor_msgs::Image>("e", 1);
    front_pub_ = nh_.advertise<sensor_msgs::Image>("f", 1);
    step_pub_ = nh_.advertise<sensor_msgs::Image>("g", 1);
    given_pub_ = nh_.advertise<sensor_msgs::CompressedImage>("h", 1);
    each_pub_ = nh_.advertise<sensor_msgs::Image>("i", 1);
    slot_pub_ = nh_.advertise<sensor_msgs::Image>("j", 1);
  }
  sensor_msgs::Image& current() {
    if (n_ % 2) return even_;
    return odd_;
  }
  void by_part_of_result() {
    auto& data = current().data;
    data[0] = n_++;
    part_pub_.publish(current());
  }
  void by_pair() {
    both_.first.data.clear();
    both_.second.data[0] = n_++;
    pair_pub_.publish(both_.second);
  }
  void by_tuple() {
    std::get<0>(two_).data.clear();
    std::get<1>(two_).data[0] = n_++;
    tuple_pub_.publish(std::get<1>(two_));
  }
  void by_index() {
    int i = n_ % 2;
    ring_[i].data.clear();
    i = 1 - i;
    ring_[i].data[0] = n_++;
    index_pub_.publish(ring_[i]);
  }
  void by_half(int k) {
    halves_[k / 2].data[0] = n_++;
    half_pub_.publish(halves_[k / 2]);
  }
  void by_front() {
    queue_.front().data.clear();
    queue_.push_back(queue_.front());
    queue_.pop_front();
    queue_.front().data[0] = n_++;
    front_pub_.publish(queue_.front());
  }
  void by_step() {
    sensor_msgs::Image* at = steps_;
    at->data.clear();
    ++at;
    at->data[0] = n_++;
    step_pub_.publish(*at);
  }
  void by_given_container() {
    touch(given_, n_++);
    given_pub_.publish(given_[0]);
  }
  void by_each() {
    for (auto& one : all_) {
      one.data.clear();
      break;
    }
    for (auto& one : all_) one.data[0] = n_++;
    each_pub_.publish(all_[1]);
  }
  void by_slot() {
    slots_[slot_].data.clear();
    slot_ = 1 - slot_;
    slots_[slot_].data[0] = n_++;
    slot_pub_.publish(slots_[slot_]);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher part_pub_, pair_pub_, tuple_pub_, index_pub_, half_pub_, front_pub_, step_pub_, given_pub_, each_pub_, slot_pub_;
  sensor_msgs::Image even_, odd_, ring_[2], halves_[4], steps_[2], slots_[2];
  std::pair<sensor_msgs::Image, sensor_msgs::Image> both_;
  std::tuple<sensor_msgs::Image, sensor_msgs::Image> two_;
  std::vector<sensor_msgs::Image> all_;
  std::deque<sensor_msgs::Image> queue_;
  std::deque<sensor_msgs::CompressedImage> given_;
  int n_ = 0, slot_ = 0;
};
//--- expected
// advertise src/node.cpp:18 sensor_msgs/Image one_copy 'a'
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'b'
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'c'
// advertise src/node.cpp:21 sensor_msgs/Image one_copy 'd'
// advertise src/node.cpp:22 sensor_msgs/Image one_copy 'e'
// advertise src/node.cpp:23 sensor_msgs/Image one_copy 'f'
// advertise src/node.cpp:24 sensor_msgs/Image one_copy 'g'
// advertise src/node.cpp:25 sensor_msgs/CompressedImage one_copy 'h'
// advertise src/node.cpp:26 sensor_msgs/Image one_copy 'i'
// advertise src/node.cpp:27 sensor_msgs/Image one_copy 'j'
// publish src/node.cpp:36 sensor_msgs/Image one_copy 'a' TZC1022 line 35 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:41 sensor_msgs/Image one_copy 'b' TZC1022 line 40 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:46 sensor_msgs/Image one_copy 'c' TZC1022 line 45 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:53 sensor_msgs/Image one_copy 'd' TZC1022 line 52 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:57 sensor_msgs/Image one_copy 'e' TZC1022 line 56 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:64 sensor_msgs/Image one_copy 'f' TZC1022 line 63 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:71 sensor_msgs/Image one_copy 'g' TZC1022 line 70 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:75 sensor_msgs/CompressedImage one_copy 'h' TZC1022 line 74 of node.cpp uses a sensor_msgs/CompressedImage, and nothing shows which: it may be this one, and be written to after this publish
// publish src/node.cpp:83 sensor_msgs/Image one_copy 'i' TZC1022 line 82 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:89 sensor_msgs/Image one_copy 'j' TZC1022 line 88 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/CompressedImage.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void touch(std::deque<sensor_msgs::CompressedImage>& given, int n) {
// +void touch(std::deque<tzc::sensor_msgs::CompressedImage>& given, int n) {
// -    part_pub_ = nh_.advertise<sensor_msgs::Image>("a", 1);
// -    pair_pub_ = nh_.advertise<sensor_msgs::Image>("b", 1);
// -    tuple_pub_ = nh_.advertise<sensor_msgs::Image>("c", 1);
// -    index_pub_ = nh_.advertise<sensor_msgs::Image>("d", 1);
// -    half_pub_ = nh_.advertise<sensor_msgs::Image>("e", 1);
// -    front_pub_ = nh_.advertise<sensor_msgs::Image>("f", 1);
// -    step_pub_ = nh_.advertise<sensor_msgs::Image>("g", 1);
// -    given_pub_ = nh_.advertise<sensor_msgs::CompressedImage>("h", 1);
// -    each_pub_ = nh_.advertise<sensor_msgs::Image>("i", 1);
// -    slot_pub_ = nh_.advertise<sensor_msgs::Image>("j", 1);
// +    part_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "a", 1);
// +    pair_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "b", 1);
// +    tuple_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "c", 1);
// +    index_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "d", 1);
// +    half_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "e", 1);
// +    front_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "f", 1);
// +    step_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "g", 1);
// +    given_pub_ = tzc::advertise<tzc::sensor_msgs::CompressedImage>(nh_, "h", 1);
// +    each_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "i", 1);
// +    slot_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "j", 1);
// -  sensor_msgs::Image& current() {
// +  tzc::sensor_msgs::Image& current() {
// -    sensor_msgs::Image* at = steps_;
// +    tzc::sensor_msgs::Image* at = steps_;
// -  ros::Publisher part_pub_, pair_pub_, tuple_pub_, index_pub_, half_pub_, front_pub_, step_pub_, given_pub_, each_pub_, slot_pub_;
// -  sensor_msgs::Image even_, odd_, ring_[2], halves_[4], steps_[2], slots_[2];
// -  std::pair<sensor_msgs::Image, sensor_msgs::Image> both_;
// -  std::tuple<sensor_msgs::Image, sensor_msgs::Image> two_;
// -  std::vector<sensor_msgs::Image> all_;
// -  std::deque<sensor_msgs::Image> queue_;
// -  std::deque<sensor_msgs::CompressedImage> given_;
// +  tzc::Publisher part_pub_, pair_pub_, tuple_pub_, index_pub_, half_pub_, front_pub_, step_pub_, given_pub_, each_pub_, slot_pub_;
// +  tzc::sensor_msgs::Image even_, odd_, ring_[2], halves_[4], steps_[2], slots_[2];
// +  std::pair<tzc::sensor_msgs::Image, tzc::sensor_msgs::Image> both_;
// +  std::tuple<tzc::sensor_msgs::Image, tzc::sensor_msgs::Image> two_;
// +  std::vector<tzc::sensor_msgs::Image> all_;
// +  std::deque<tzc::sensor_msgs::Image> queue_;
// +  std::deque<tzc::sensor_msgs::CompressedImage> given_;
