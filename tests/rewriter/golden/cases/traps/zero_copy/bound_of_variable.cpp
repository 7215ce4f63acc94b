// A number that the compiler does not know, whatever is asked about it before.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>

void run(ros::NodeHandle& nh, unsigned n) {
  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
  std_msgs::Float32MultiArray narrowed;
  if (n < 100) narrowed.data.resize(n);
  pub.publish(narrowed);
  std_msgs::Float32MultiArray modified;
  unsigned size = 3;
  size *= n;
  modified.data.resize(size);
  pub.publish(modified);
  std_msgs::Float32MultiArray constant;
  const unsigned copy = n;
  constant.data.resize(copy);
  pub.publish(constant);
  std_msgs::Float32MultiArray counted;
  for (unsigned i = 1; i < 4; ++i) counted.data.resize(i * n);
  pub.publish(counted);
  std_msgs::Float32MultiArray chosen;
  chosen.data.assign(n > 3 ? n : 3, 1.0f);
  pub.publish(chosen);
}
//--- expected
// advertise src/node.cpp:7 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:10 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:15 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:19 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:22 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:25 std_msgs/Float32MultiArray zero_copy 'values'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/std_msgs/Float32MultiArray.h>
// -  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
// -  std_msgs::Float32MultiArray narrowed;
// +  tzc::Publisher pub = tzc::advertise<tzc::std_msgs::Float32MultiArray>(nh, "values", 10);
// +  tzc::std_msgs::Float32MultiArray narrowed;
// +  pub.allocate(narrowed);
// -  std_msgs::Float32MultiArray modified;
// +  tzc::std_msgs::Float32MultiArray modified;
// +  pub.allocate(modified);
// -  std_msgs::Float32MultiArray constant;
// +  tzc::std_msgs::Float32MultiArray constant;
// +  pub.allocate(constant);
// -  std_msgs::Float32MultiArray counted;
// +  tzc::std_msgs::Float32MultiArray counted;
// +  pub.allocate(counted);
// -  std_msgs::Float32MultiArray chosen;
// +  tzc::std_msgs::Float32MultiArray chosen;
// +  pub.allocate(chosen);
