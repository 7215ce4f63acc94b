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
