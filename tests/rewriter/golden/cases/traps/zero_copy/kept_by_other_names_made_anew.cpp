// As kept_by_other_names.cpp, but each message is built anew before it is published.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Indices {
 public:
  explicit Indices(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("indices", 1)) {
    frames_[0].reset(new sensor_msgs::Image);
    frames_[1].reset(new sensor_msgs::Image);
  }
  void tick(int k) {
    frames_[1 - front_]->data.assign(6000, 0);
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
    frames_[k % 2]->data.assign(6000, 0);
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
    frame->data.assign(6000, 0);
    frame->data[k] = 1;
    pub_.publish(*frame);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image even_, odd_;
};

class LeftAndRight {
 public:
  explicit LeftAndRight(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("both", 1)) {
    frames_[0].reset(new sensor_msgs::Image);
    frames_[1].reset(new sensor_msgs::Image);
  }
  void tick(int k) {
    frames_[0]->data.assign(6000, 0);
    frames_[1]->data.assign(6000, 0);
    frames_[0]->data[k] = 1;
    pub_.publish(frames_[0]);
    frames_[1]->data[k] = 2;
    pub_.publish(frames_[1]);
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
  LeftAndRight both(nh);
  for (int k = 0; k < 9; ++k) {
    indices.tick(k);
    pointer.tick(k);
    local.tick(k);
    both.tick(k);
  }
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'indices'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'indices'
// advertise src/node.cpp:26 sensor_msgs/Image zero_copy 'pointer'
// publish src/node.cpp:34 sensor_msgs/Image zero_copy 'pointer'
// advertise src/node.cpp:45 sensor_msgs/Image zero_copy 'local'
// publish src/node.cpp:51 sensor_msgs/Image zero_copy 'local'
// advertise src/node.cpp:61 sensor_msgs/Image zero_copy 'both'
// publish src/node.cpp:69 sensor_msgs/Image zero_copy 'both'
// publish src/node.cpp:71 sensor_msgs/Image zero_copy 'both'
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
// -  explicit LeftAndRight(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("both", 1)) {
// -    frames_[0].reset(new sensor_msgs::Image);
// -    frames_[1].reset(new sensor_msgs::Image);
// +  explicit LeftAndRight(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "both", 1)) {
// +    frames_[0].reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*frames_[0]);
// +    frames_[1].reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*frames_[1]);
// -  ros::Publisher pub_;
// -  sensor_msgs::ImagePtr frames_[2];
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::ImagePtr frames_[2];
