// One element each time, and the message is kept for the next time.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>
#include <vector>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<std_msgs::Float32MultiArray>("values", 10)) {}
  void copied() {
    std_msgs::Float32MultiArray next;
    next = last_;
    next.data.push_back(1);
    last_ = next;
    pub_.publish(next);
  }
  void swapped() {
    std_msgs::Float32MultiArray next;
    std::swap(next, other_);
    next.data.push_back(1);
    std::swap(next, other_);
    pub_.publish(other_);
  }
  void pointed() {
    boost::shared_ptr<std_msgs::Float32MultiArray> next(new std_msgs::Float32MultiArray);
    for (int i = 0; i < 2000; ++i) next->data.push_back(1);
    pub_.publish(next);
  }

 private:
  ros::Publisher pub_;
  std_msgs::Float32MultiArray last_, other_;
};
//--- expected
// advertise src/node.cpp:9 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:15 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:22 std_msgs/Float32MultiArray one_copy 'values' TZC1022 line 20 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:27 std_msgs/Float32MultiArray zero_copy 'values'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/std_msgs/Float32MultiArray.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<std_msgs::Float32MultiArray>("values", 10)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::std_msgs::Float32MultiArray>(nh, "values", 10)) {}
// -    std_msgs::Float32MultiArray next;
// +    tzc::std_msgs::Float32MultiArray next;
// +    pub_.allocate(next);
// -    std_msgs::Float32MultiArray next;
// +    tzc::std_msgs::Float32MultiArray next;
// +    pub_.allocate(next);
// -    boost::shared_ptr<std_msgs::Float32MultiArray> next(new std_msgs::Float32MultiArray);
// +    boost::shared_ptr<tzc::std_msgs::Float32MultiArray> next(new tzc::std_msgs::Float32MultiArray);
// +    pub_.allocate(*next);
// -  ros::Publisher pub_;
// -  std_msgs::Float32MultiArray last_, other_;
// +  tzc::Publisher pub_;
// +  tzc::std_msgs::Float32MultiArray last_, other_;
