// A member that is given away and made empty by an assignment is never published itself, and so never allocated.
#include <deque>
#include <utility>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("queued", 1)) {}
  void fill(int k) {
    for (int i = 0; i < 5000; ++i) frame_.data.push_back(k);
    queue_.push_back(std::move(frame_));
    frame_ = sensor_msgs::Image();
  }
  void send() {
    pub_.publish(queue_.front());
    queue_.pop_front();
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image frame_;
  std::deque<sensor_msgs::Image> queue_;
};

void run(ros::NodeHandle& nh) {
  Node node(nh);
  for (int k = 0; ros::ok(); ++k) {
    node.fill(k);
    node.send();
  }
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'queued'
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'queued' TZC1022 its elements come from a message that is never published itself (stored by 'push_back' in line 13), and lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("queued", 1)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "queued", 1)) {}
// -    frame_ = sensor_msgs::Image();
// +    frame_ = tzc::sensor_msgs::Image();
// -  ros::Publisher pub_;
// -  sensor_msgs::Image frame_;
// -  std::deque<sensor_msgs::Image> queue_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image frame_;
// +  std::deque<tzc::sensor_msgs::Image> queue_;
