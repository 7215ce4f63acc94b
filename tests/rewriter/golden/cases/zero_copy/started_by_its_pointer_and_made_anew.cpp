// The constructor gives the pointer its first message, and each callback the next one, which is allocated there.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() : next_(new sensor_msgs::Image), front_(new sensor_msgs::Image), back_(new sensor_msgs::Image) {
    timer_ = nh_.createTimer(ros::Duration(0.1), &Node::tick, this);
  }
  void tick(const ros::TimerEvent&) {
    next_->data.resize(++count_);
    pub_.publish(next_);
    next_.reset(new sensor_msgs::Image);
    back_->data.assign(count_, 2);
    std::swap(front_, back_);
    send(*front_);
  }

 private:
  void send(const sensor_msgs::Image& image) { pub_.publish(image); }
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::ImagePtr next_, front_, back_;
  ros::Timer timer_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:22 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() : next_(new sensor_msgs::Image), front_(new sensor_msgs::Image), back_(new sensor_msgs::Image) {
// +  Node() : next_(new tzc::sensor_msgs::Image), front_(new tzc::sensor_msgs::Image), back_(new tzc::sensor_msgs::Image) {
// -    next_.reset(new sensor_msgs::Image);
// +    next_.reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*next_);
// -  void send(const sensor_msgs::Image& image) { pub_.publish(image); }
// +  void send(const tzc::sensor_msgs::Image& image) { pub_.publish(image); }
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::ImagePtr next_, front_, back_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::sensor_msgs::ImagePtr next_, front_, back_;
