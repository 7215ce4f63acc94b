// push_back that runs more often than it is written: loops, lambdas, recursion, a switch in a loop.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>

void add(std_msgs::Float32MultiArray& values, int n) {
  values.data.push_back(1);
  if (n > 0) add(values, n - 1);
}

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
  std_msgs::Float32MultiArray in_while;
  while (--n > 0) in_while.data.emplace_back(1);
  pub.publish(in_while);
  std_msgs::Float32MultiArray in_do;
  do in_do.data.push_back(1);
  while (--n > 0);
  pub.publish(in_do);
  std_msgs::Float32MultiArray in_range;
  for (int one : {1, 2, 3}) in_range.data.push_back(one);
  pub.publish(in_range);
  std_msgs::Float32MultiArray in_lambda;
  const auto append = [&in_lambda] { in_lambda.data.push_back(1); };
  for (int i = 0; i < n; ++i) append();
  pub.publish(in_lambda);
  std_msgs::Float32MultiArray recursive;
  add(recursive, n);
  pub.publish(recursive);
}
//--- expected
// advertise src/node.cpp:12 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:15 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:19 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:22 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:26 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:29 std_msgs/Float32MultiArray zero_copy 'values'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/std_msgs/Float32MultiArray.h>
// -void add(std_msgs::Float32MultiArray& values, int n) {
// +void add(tzc::std_msgs::Float32MultiArray& values, int n) {
// -  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
// -  std_msgs::Float32MultiArray in_while;
// +  tzc::Publisher pub = tzc::advertise<tzc::std_msgs::Float32MultiArray>(nh, "values", 10);
// +  tzc::std_msgs::Float32MultiArray in_while;
// +  pub.allocate(in_while);
// -  std_msgs::Float32MultiArray in_do;
// +  tzc::std_msgs::Float32MultiArray in_do;
// +  pub.allocate(in_do);
// -  std_msgs::Float32MultiArray in_range;
// +  tzc::std_msgs::Float32MultiArray in_range;
// +  pub.allocate(in_range);
// -  std_msgs::Float32MultiArray in_lambda;
// +  tzc::std_msgs::Float32MultiArray in_lambda;
// +  pub.allocate(in_lambda);
// -  std_msgs::Float32MultiArray recursive;
// +  tzc::std_msgs::Float32MultiArray recursive;
// +  pub.allocate(recursive);
