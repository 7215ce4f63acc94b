// Each instance makes a number of elements that is known; the template itself does not, and is taken for large.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>

template <int N>
void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
  std_msgs::Float32MultiArray values;
  values.data.resize(N);
  pub.publish(values);
}

void both(ros::NodeHandle& nh) {
  run<3>(nh);
  run<4>(nh);
}

//--- expected
// advertise src/node.cpp:8 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:11 std_msgs/Float32MultiArray zero_copy 'values'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/std_msgs/Float32MultiArray.h>
// -  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
// -  std_msgs::Float32MultiArray values;
// +  tzc::Publisher pub = tzc::advertise<tzc::std_msgs::Float32MultiArray>(nh, "values", 10);
// +  tzc::std_msgs::Float32MultiArray values;
// +  pub.allocate(values);
