// Members that hold messages which are new each time, or are given a vector's elements: their publish copies them.
#include <deque>
#include <map>
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void draw(sensor_msgs::Image& image, int k) {
  image.data.resize(5000);
  for (int i = 0; i < 5000; ++i) image.data[i] = k + i;
}

class Queued {
 public:
  explicit Queued(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("queued", 1)) {}
  void step(int k) {
    queue_.emplace_back();
    draw(queue_.back(), k);
    pub_.publish(queue_.front());
    queue_.pop_front();
  }

 private:
  ros::Publisher pub_;
  std::deque<sensor_msgs::Image> queue_;
};

class Resized {
 public:
  explicit Resized(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("resized", 1)) {}
  void step(int k) {
    frames_.clear();
    frames_.resize(1);
    draw(frames_[0], k);
    pub_.publish(frames_[0]);
  }

 private:
  ros::Publisher pub_;
  std::vector<sensor_msgs::Image> frames_;
};

class Named {
 public:
  explicit Named(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("named", 1)) {}
  void step(int k) {
    draw(frames_[k], k);
    for (auto& one : frames_) pub_.publish(one.second);
    frames_.erase(k);
  }

 private:
  ros::Publisher pub_;
  std::map<int, sensor_msgs::Image> frames_;
};

class Stepped {
 public:
  explicit Stepped(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("stepped", 1)) {}
  void step(int k) {
    sensor_msgs::Image* at = frames_;
    at->data = std::vector<unsigned char>(5000, k);
    pub_.publish(*at++);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image frames_[2];
};

class ByClosure {
 public:
  explicit ByClosure(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("by_closure", 1)) {}
  void step(int k) {
    auto next = [&]() -> sensor_msgs::Image& { return frames_[k++ % 2]; };
    next().data = std::vector<unsigned char>(5000, k);
    pub_.publish(next());
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image frames_[2];
};

void run(ros::NodeHandle& nh) {
  Queued queued(nh);
  Resized resized(nh);
  Named named(nh);
  Stepped stepped(nh);
  ByClosure by_closure(nh);
  for (int k = 0; ros::ok(); ++k) {
    queued.step(k);
    resized.step(k);
    named.step(k);
    stepped.step(k);
    by_closure.step(k);
  }
}
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'queued'
// publish src/node.cpp:20 sensor_msgs/Image one_copy 'queued' TZC1022 line 18 puts new messages into the container ('emplace_back'), whose elements lie outside shared memory until they are published
// advertise src/node.cpp:31 sensor_msgs/Image one_copy 'resized'
// publish src/node.cpp:36 sensor_msgs/Image one_copy 'resized' TZC1022 line 34 puts new messages into the container ('resize'), whose elements lie outside shared memory until they are published
// advertise src/node.cpp:46 sensor_msgs/Image one_copy 'named'
// publish src/node.cpp:49 sensor_msgs/Image one_copy 'named' TZC1022 line 48 puts new messages into the container ('[]'), whose elements lie outside shared memory until they are published
// advertise src/node.cpp:60 sensor_msgs/Image zero_copy 'stepped'
// publish src/node.cpp:64 sensor_msgs/Image zero_copy 'stepped'
// advertise src/node.cpp:74 sensor_msgs/Image one_copy 'by_closure'
// publish src/node.cpp:78 sensor_msgs/Image one_copy 'by_closure' TZC1022 line 77 gives it elements that lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void draw(sensor_msgs::Image& image, int k) {
// -  image.data.resize(5000);
// +void draw(tzc::sensor_msgs::Image& image, int k) {
// +  image.data.resize(5000, tzc::uninitialized);
// -  explicit Queued(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("queued", 1)) {}
// +  explicit Queued(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "queued", 1)) {}
// -  ros::Publisher pub_;
// -  std::deque<sensor_msgs::Image> queue_;
// +  tzc::Publisher pub_;
// +  std::deque<tzc::sensor_msgs::Image> queue_;
// -  explicit Resized(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("resized", 1)) {}
// +  explicit Resized(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "resized", 1)) {}
// -  ros::Publisher pub_;
// -  std::vector<sensor_msgs::Image> frames_;
// +  tzc::Publisher pub_;
// +  std::vector<tzc::sensor_msgs::Image> frames_;
// -  explicit Named(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("named", 1)) {}
// +  explicit Named(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "named", 1)) {}
// -  ros::Publisher pub_;
// -  std::map<int, sensor_msgs::Image> frames_;
// +  tzc::Publisher pub_;
// +  std::map<int, tzc::sensor_msgs::Image> frames_;
// -  explicit Stepped(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("stepped", 1)) {}
// +  explicit Stepped(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "stepped", 1)) {}
// -    sensor_msgs::Image* at = frames_;
// -    at->data = std::vector<unsigned char>(5000, k);
// +    tzc::sensor_msgs::Image* at = frames_;
// +    at->data.assign(5000, k);
// -  ros::Publisher pub_;
// -  sensor_msgs::Image frames_[2];
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image frames_[2];
// -  explicit ByClosure(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("by_closure", 1)) {}
// +  explicit ByClosure(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "by_closure", 1)) {}
// -    auto next = [&]() -> sensor_msgs::Image& { return frames_[k++ % 2]; };
// +    auto next = [&]() -> tzc::sensor_msgs::Image& { return frames_[k++ % 2]; };
// -  ros::Publisher pub_;
// -  sensor_msgs::Image frames_[2];
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image frames_[2];
