// What is written is what was published the time before, under another name: by another index, through a pointer, in a loop.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Indices {
 public:
  explicit Indices(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("indices", 1)) {
    frames_[0].reset(new sensor_msgs::Image);
    frames_[1].reset(new sensor_msgs::Image);
  }
  void tick(int k) {
    frames_[1 - front_]->data.resize(6000);
    frames_[1 - front_]->data[k] = 1;
    front_ = 1 - front_;
    pub_.publish(frames_[front_]);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::ImagePtr frames_[2];
  int front_ = 0;
};

class Pointer {
 public:
  explicit Pointer(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("pointer", 1)) {
    frames_[0].reset(new sensor_msgs::Image);
    frames_[1].reset(new sensor_msgs::Image);
  }
  void tick(int k) {
    for (auto& frame : frames_) frame->data.resize(6000);
    frames_[k % 2]->data[k] = 1;
    current_ = frames_[k % 2].get();
    pub_.publish(*current_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::ImagePtr frames_[2];
  sensor_msgs::Image* current_ = nullptr;
};

class Local {
 public:
  explicit Local(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("local", 1)) {}
  void tick(int k) {
    sensor_msgs::Image* frame = &even_;
    if (k % 2) frame = &odd_;
    frame->data.resize(6000);
    frame->data[k] = 1;
    pub_.publish(*frame);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image even_, odd_;
};

class Loop {
 public:
  explicit Loop(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("loop", 1)) {
    frames_[0].reset(new sensor_msgs::Image);
    frames_[1].reset(new sensor_msgs::Image);
  }
  void tick(int k) {
    for (const sensor_msgs::ImagePtr& frame : frames_) pub_.publish(frame);
    frames_[k % 2]->data.resize(6000);
    frames_[k % 2]->data[k] = 1;
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::ImagePtr frames_[2];
};

int main() {
  ros::NodeHandle nh;
  Indices indices(nh);
  Pointer pointer(nh);
  Local local(nh);
  Loop loop(nh);
  for (int k = 0; k < 9; ++k) {
    indices.tick(k);
    pointer.tick(k);
    local.tick(k);
    loop.tick(k);
  }
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'indices'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'indices' TZC1022 line 13 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:26 sensor_msgs/Image one_copy 'pointer'
// publish src/node.cpp:34 sensor_msgs/Image one_copy 'pointer' TZC1022 line 32 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:45 sensor_msgs/Image one_copy 'local'
// publish src/node.cpp:51 sensor_msgs/Image one_copy 'local' TZC1022 line 50 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:61 sensor_msgs/Image one_copy 'loop'
// publish src/node.cpp:66 sensor_msgs/Image one_copy 'loop' TZC1022 line 68 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Indices(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("indices", 1)) {
// -    frames_[0].reset(new sensor_msgs::Image);
// -    frames_[1].reset(new sensor_msgs::Image);
// +  explicit Indices(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "indices", 1)) {
// +    frames_[0].reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*frames_[0]);
// +    frames_[1].reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*frames_[1]);
// -  ros::Publisher pub_;
// -  sensor_msgs::ImagePtr frames_[2];
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::ImagePtr frames_[2];
// -  explicit Pointer(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("pointer", 1)) {
// -    frames_[0].reset(new sensor_msgs::Image);
// -    frames_[1].reset(new sensor_msgs::Image);
// +  explicit Pointer(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "pointer", 1)) {
// +    frames_[0].reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*frames_[0]);
// +    frames_[1].reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*frames_[1]);
// -  ros::Publisher pub_;
// -  sensor_msgs::ImagePtr frames_[2];
// -  sensor_msgs::Image* current_ = nullptr;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::ImagePtr frames_[2];
// +  tzc::sensor_msgs::Image* current_ = nullptr;
// -  explicit Local(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("local", 1)) {}
// +  explicit Local(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "local", 1)) {}
// -    sensor_msgs::Image* frame = &even_;
// +    tzc::sensor_msgs::Image* frame = &even_;
// -  ros::Publisher pub_;
// -  sensor_msgs::Image even_, odd_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image even_, odd_;
// -  explicit Loop(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("loop", 1)) {
// -    frames_[0].reset(new sensor_msgs::Image);
// -    frames_[1].reset(new sensor_msgs::Image);
// +  explicit Loop(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "loop", 1)) {
// +    frames_[0].reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*frames_[0]);
// +    frames_[1].reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*frames_[1]);
// -    for (const sensor_msgs::ImagePtr& frame : frames_) pub_.publish(frame);
// +    for (const tzc::sensor_msgs::ImagePtr& frame : frames_) pub_.publish(frame);
// -  ros::Publisher pub_;
// -  sensor_msgs::ImagePtr frames_[2];
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::ImagePtr frames_[2];
