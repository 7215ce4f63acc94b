// Numbers that wrap around: -1 elements, and a product of int.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
  std_msgs::Float32MultiArray negative;
  negative.data.resize(-1);
  pub.publish(negative);
  std_msgs::Float32MultiArray enormous;
  enormous.data.resize(1ull << 62);
  pub.publish(enormous);
  std_msgs::Float32MultiArray narrow;
  const short size = static_cast<short>(40000);
  narrow.data.resize(size);
  pub.publish(narrow);
}
//--- expected
// advertise src/node.cpp:7 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:10 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:13 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:17 std_msgs/Float32MultiArray zero_copy 'values'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/std_msgs/Float32MultiArray.h>
// -  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
// -  std_msgs::Float32MultiArray negative;
// +  tzc::Publisher pub = tzc::advertise<tzc::std_msgs::Float32MultiArray>(nh, "values", 10);
// +  tzc::std_msgs::Float32MultiArray negative;
// +  pub.allocate(negative);
// -  std_msgs::Float32MultiArray enormous;
// +  tzc::std_msgs::Float32MultiArray enormous;
// +  pub.allocate(enormous);
// -  std_msgs::Float32MultiArray narrow;
// +  tzc::std_msgs::Float32MultiArray narrow;
// +  pub.allocate(narrow);
