// A message that keeps growing: one element each time, never cleared.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<std_msgs::Float32MultiArray>("values", 10)) {}
  void tick() {
    member_.data.push_back(1);
    pub_.publish(member_);
    static std_msgs::Float32MultiArray kept;
    kept.data.push_back(1);
    pub_.publish(kept);
  }

 private:
  ros::Publisher pub_;
  std_msgs::Float32MultiArray member_;
};
//--- expected
// advertise src/node.cpp:8 std_msgs/Float32MultiArray one_copy 'values'
// publish src/node.cpp:11 std_msgs/Float32MultiArray one_copy 'values' TZC1022 line 10 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:14 std_msgs/Float32MultiArray one_copy 'values' TZC1022 line 13 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/std_msgs/Float32MultiArray.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<std_msgs::Float32MultiArray>("values", 10)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::std_msgs::Float32MultiArray>(nh, "values", 10)) {}
// -    static std_msgs::Float32MultiArray kept;
// +    static tzc::std_msgs::Float32MultiArray kept;
// -  ros::Publisher pub_;
// -  std_msgs::Float32MultiArray member_;
// +  tzc::Publisher pub_;
// +  tzc::std_msgs::Float32MultiArray member_;
