// Nothing publishes the message that is copied, so it stays a stock one, and no ported message can start as a copy of it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void keep(int count) { last_.data.assign(count, 1); }
  void send() {
    if (sensor_msgs::Image out = last_; !out.data.empty()) pub_.publish(out);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image last_;
};
//--- expected
