// push_back in a loop, through a reference, and behind a label: any number of elements.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>

void add(std_msgs::Float32MultiArray& values) {
  values.data.push_back(1);
}

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
  std_msgs::Float32MultiArray looped;
  for (int i = 0; i < n; ++i) looped.data.push_back(1);
  pub.publish(looped);
  std_msgs::Float32MultiArray passed;
  for (int i = 0; i < n; ++i) add(passed);
  pub.publish(passed);
}

void jump(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
  std_msgs::Float32MultiArray jumped;
again:
  jumped.data.push_back(1);
  if (--n > 0) goto again;
  pub.publish(jumped);
}
//--- expected
// advertise src/node.cpp:11 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:14 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:17 std_msgs/Float32MultiArray zero_copy 'values'
// advertise src/node.cpp:21 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:26 std_msgs/Float32MultiArray zero_copy 'values'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/std_msgs/Float32MultiArray.h>
// -void add(std_msgs::Float32MultiArray& values) {
// +void add(tzc::std_msgs::Float32MultiArray& values) {
// -  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
// -  std_msgs::Float32MultiArray looped;
// +  tzc::Publisher pub = tzc::advertise<tzc::std_msgs::Float32MultiArray>(nh, "values", 10);
// +  tzc::std_msgs::Float32MultiArray looped;
// +  pub.allocate(looped);
// -  std_msgs::Float32MultiArray passed;
// +  tzc::std_msgs::Float32MultiArray passed;
// +  pub.allocate(passed);
// -  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
// -  std_msgs::Float32MultiArray jumped;
// +  tzc::Publisher pub = tzc::advertise<tzc::std_msgs::Float32MultiArray>(nh, "values", 10);
// +  tzc::std_msgs::Float32MultiArray jumped;
// +  pub.allocate(jumped);
