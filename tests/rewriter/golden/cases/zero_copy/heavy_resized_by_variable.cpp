// One use makes a number of elements that is not known, the others do not help.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>
#include <vector>

void run(ros::NodeHandle& nh, const std::vector<float>& input, unsigned n) {
  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
  std_msgs::Float32MultiArray resized;
  resized.data.resize(3);
  resized.data.resize(n);
  pub.publish(resized);
  std_msgs::Float32MultiArray copied;
  copied.data = input;
  pub.publish(copied);
  std_msgs::Float32MultiArray ranged;
  ranged.data.assign(input.begin(), input.end());
  pub.publish(ranged);
}
//--- expected
// advertise src/node.cpp:8 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:12 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:15 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:18 std_msgs/Float32MultiArray zero_copy 'values'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/std_msgs/Float32MultiArray.h>
// -  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
// -  std_msgs::Float32MultiArray resized;
// +  tzc::Publisher pub = tzc::advertise<tzc::std_msgs::Float32MultiArray>(nh, "values", 10);
// +  tzc::std_msgs::Float32MultiArray resized;
// +  pub.allocate(resized);
// -  std_msgs::Float32MultiArray copied;
// +  tzc::std_msgs::Float32MultiArray copied;
// +  pub.allocate(copied);
// -  std_msgs::Float32MultiArray ranged;
// +  tzc::std_msgs::Float32MultiArray ranged;
// +  pub.allocate(ranged);
