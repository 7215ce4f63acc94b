// What leads to the publisher changes between the message and its publisher, but not by its own name: memory is the node's.
#include <deque>
#include <functional>
#include <memory>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <utility>
#include <vector>

struct Output {
  std::shared_ptr<ros::Publisher> pub;
};

class Node {
 public:
  Node() : left_(nh_.advertise<sensor_msgs::Image>("left", 1)), right_(nh_.advertise<sensor_msgs::Image>("right", 1)) {
    fallback_ = std::make_shared<ros::Publisher>(left_);
  }
  void by_element(int i) {
    sensor_msgs::Image image;
    image.data.resize(101);
    if (!shared_[i]) shared_[i] = fallback_;
    shared_[i]->publish(image);
  }
  void by_element_of_array(int i) {
    sensor_msgs::Image image;
    image.data.resize(102);
    if (!raw_[i]) raw_[i] = i % 2 ? &right_ : &left_;
    raw_[i]->publish(image);
  }
  void by_reference_to_element(int i) {
    sensor_msgs::Image image;
    image.data.resize(103);
    auto& slot = shared_[i];
    if (!slot) slot = fallback_;
    shared_[i]->publish(image);
  }
  void by_swap() {
    sensor_msgs::Image image;
    image.data.resize(104);
    std::swap(shared_[0], fallback_);
    shared_[0]->publish(image);
  }
  void by_reset(int i) {
    std::vector<std::unique_ptr<ros::Publisher>> own(2);
    sensor_msgs::Image image;
    image.data.resize(105);
    own[0].reset(new ros::Publisher(left_));
    own[i]->publish(image);
  }
  void by_object_around(int i) {
    sensor_msgs::Image image;
    image.data.resize(106);
    outputs_[i] = Output{fallback_};
    outputs_[i].pub->publish(image);
  }
  void by_deque(int i) {
    sensor_msgs::Image image;
    image.data.resize(107);
    if (!queue_[i]) queue_[i] = fallback_;
    queue_[i]->publish(image);
  }
  void by_loop() {
    sensor_msgs::Image image;
    image.data.resize(108);
    for (auto& slot : shared_) slot = fallback_;
    shared_[0]->publish(image);
  }
  void by_reference() {
    auto& current = current_;
    sensor_msgs::Image image;
    image.data.resize(109);
    current = &left_;
    current_->publish(image);
  }
  void by_pointer() {
    ros::Publisher* pub = nullptr;
    ros::Publisher* other = &left_;
    ros::Publisher** where = &pub;
    sensor_msgs::Image image;
    image.data.resize(110);
    std::swap(*where, other);
    pub->publish(image);
  }
  void by_pointer_into_array() {
    ros::Publisher* pubs[1] = {nullptr};
    ros::Publisher** where = pubs;
    sensor_msgs::Image image;
    image.data.resize(111);
    *where = &left_;
    pubs[0]->publish(image);
  }
  void where_pointer_leads() {
    ros::Publisher* pub = nullptr;
    ros::Publisher** where = &pub;
    sensor_msgs::Image image;
    image.data.resize(112);
    pub = &left_;
    (*where)->publish(image);
  }
  void by_closure() {
    ros::Publisher* pub = nullptr;
    ros::Publisher*& same = pub;
    auto choose = [&] { same = &left_; };
    sensor_msgs::Image image;
    image.data.resize(113);
    choose();
    pub->publish(image);
  }
  void by_function_object() {
    ros::Publisher* pub = nullptr;
    std::function<void()> choose = [&pub, this] { pub = &left_; };
    sensor_msgs::Image image;
    image.data.resize(114);
    choose();
    pub->publish(image);
  }
  void by_helper() {
    ros::Publisher* pub = nullptr;
    ros::Publisher*& same = pub;
    sensor_msgs::Image image;
    image.data.resize(115);
    set(same);
    pub->publish(image);
  }
  void by_iterator() {
    std::vector<ros::Publisher*> pubs(1);
    auto it = pubs.begin();
    sensor_msgs::Image image;
    image.data.resize(116);
    *it = &left_;
    pubs[0]->publish(image);
  }
  void by_index() {
    int which = -1000000;
    int& same = which;
    ros::Publisher* all[2] = {&left_, &right_};
    sensor_msgs::Image image;
    image.data.resize(117);
    same = 1;
    all[which]->publish(image);
  }
  void by_step() {
    auto it = steps_.begin();
    sensor_msgs::Image image;
    image.data.resize(118);
    ++it;
    (*it)->publish(image);
  }
  void by_destructor() {
    sensor_msgs::Image image;
    image.data.resize(119);
    { Setter setter(current_, &left_); }
    current_->publish(image);
  }

 private:
  struct Setter {
    Setter(ros::Publisher*& where, ros::Publisher* what) : where(where), what(what) {}
    ~Setter() { where = what; }
    ros::Publisher*& where;
    ros::Publisher* what;
  };
  void set(ros::Publisher*& where) { where = &right_; }

  ros::NodeHandle nh_;
  ros::Publisher left_, right_;
  ros::Publisher* current_ = nullptr;
  ros::Publisher* raw_[4] = {};
  std::shared_ptr<ros::Publisher> fallback_;
  std::vector<std::shared_ptr<ros::Publisher>> shared_{4};
  std::vector<Output> outputs_{2};
  std::deque<std::shared_ptr<ros::Publisher>> queue_{4};
  std::vector<ros::Publisher*> steps_{nullptr, &left_};
};
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'right'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy
// publish src/node.cpp:29 sensor_msgs/Image zero_copy
// publish src/node.cpp:36 sensor_msgs/Image zero_copy
// publish src/node.cpp:42 sensor_msgs/Image zero_copy
// publish src/node.cpp:49 sensor_msgs/Image zero_copy
// publish src/node.cpp:55 sensor_msgs/Image zero_copy
// publish src/node.cpp:61 sensor_msgs/Image zero_copy
// publish src/node.cpp:67 sensor_msgs/Image zero_copy
// publish src/node.cpp:74 sensor_msgs/Image zero_copy
// publish src/node.cpp:83 sensor_msgs/Image zero_copy
// publish src/node.cpp:91 sensor_msgs/Image zero_copy
// publish src/node.cpp:99 sensor_msgs/Image zero_copy
// publish src/node.cpp:108 sensor_msgs/Image zero_copy
// publish src/node.cpp:116 sensor_msgs/Image zero_copy
// publish src/node.cpp:124 sensor_msgs/Image zero_copy
// publish src/node.cpp:132 sensor_msgs/Image zero_copy
// publish src/node.cpp:141 sensor_msgs/Image zero_copy
// publish src/node.cpp:148 sensor_msgs/Image zero_copy
// publish src/node.cpp:154 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  std::shared_ptr<ros::Publisher> pub;
// +  std::shared_ptr<tzc::Publisher> pub;
// -  Node() : left_(nh_.advertise<sensor_msgs::Image>("left", 1)), right_(nh_.advertise<sensor_msgs::Image>("right", 1)) {
// -    fallback_ = std::make_shared<ros::Publisher>(left_);
// +  Node() : left_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "left", 1)), right_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "right", 1)) {
// +    fallback_ = std::make_shared<tzc::Publisher>(left_);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    std::vector<std::unique_ptr<ros::Publisher>> own(2);
// -    sensor_msgs::Image image;
// +    std::vector<std::unique_ptr<tzc::Publisher>> own(2);
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    own[0].reset(new ros::Publisher(left_));
// +    own[0].reset(new tzc::Publisher(left_));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    ros::Publisher* pub = nullptr;
// -    ros::Publisher* other = &left_;
// -    ros::Publisher** where = &pub;
// -    sensor_msgs::Image image;
// +    tzc::Publisher* pub = nullptr;
// +    tzc::Publisher* other = &left_;
// +    tzc::Publisher** where = &pub;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    ros::Publisher* pubs[1] = {nullptr};
// -    ros::Publisher** where = pubs;
// -    sensor_msgs::Image image;
// +    tzc::Publisher* pubs[1] = {nullptr};
// +    tzc::Publisher** where = pubs;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    ros::Publisher* pub = nullptr;
// -    ros::Publisher** where = &pub;
// -    sensor_msgs::Image image;
// +    tzc::Publisher* pub = nullptr;
// +    tzc::Publisher** where = &pub;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    ros::Publisher* pub = nullptr;
// -    ros::Publisher*& same = pub;
// +    tzc::Publisher* pub = nullptr;
// +    tzc::Publisher*& same = pub;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    ros::Publisher* pub = nullptr;
// +    tzc::Publisher* pub = nullptr;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    ros::Publisher* pub = nullptr;
// -    ros::Publisher*& same = pub;
// -    sensor_msgs::Image image;
// +    tzc::Publisher* pub = nullptr;
// +    tzc::Publisher*& same = pub;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    std::vector<ros::Publisher*> pubs(1);
// +    std::vector<tzc::Publisher*> pubs(1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    ros::Publisher* all[2] = {&left_, &right_};
// -    sensor_msgs::Image image;
// +    tzc::Publisher* all[2] = {&left_, &right_};
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    left_.allocate(image);
// -    Setter(ros::Publisher*& where, ros::Publisher* what) : where(where), what(what) {}
// +    Setter(tzc::Publisher*& where, tzc::Publisher* what) : where(where), what(what) {}
// -    ros::Publisher*& where;
// -    ros::Publisher* what;
// +    tzc::Publisher*& where;
// +    tzc::Publisher* what;
// -  void set(ros::Publisher*& where) { where = &right_; }
// +  void set(tzc::Publisher*& where) { where = &right_; }
// -  ros::Publisher left_, right_;
// -  ros::Publisher* current_ = nullptr;
// -  ros::Publisher* raw_[4] = {};
// -  std::shared_ptr<ros::Publisher> fallback_;
// -  std::vector<std::shared_ptr<ros::Publisher>> shared_{4};
// +  tzc::Publisher left_, right_;
// +  tzc::Publisher* current_ = nullptr;
// +  tzc::Publisher* raw_[4] = {};
// +  std::shared_ptr<tzc::Publisher> fallback_;
// +  std::vector<std::shared_ptr<tzc::Publisher>> shared_{4};
// -  std::deque<std::shared_ptr<ros::Publisher>> queue_{4};
// -  std::vector<ros::Publisher*> steps_{nullptr, &left_};
// +  std::deque<std::shared_ptr<tzc::Publisher>> queue_{4};
// +  std::vector<tzc::Publisher*> steps_{nullptr, &left_};
