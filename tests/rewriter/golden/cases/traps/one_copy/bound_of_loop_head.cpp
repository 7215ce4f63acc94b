// push_back into a message that is declared in a loop's head.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
  for (std_msgs::Float32MultiArray in_head; n > 0; --n) {
    in_head.data.push_back(1);
    pub.publish(in_head);
  }
}
//--- expected
// advertise src/node.cpp:7 std_msgs/Float32MultiArray one_copy 'values'
// publish src/node.cpp:10 std_msgs/Float32MultiArray one_copy 'values' TZC1019 it is built in the head of a statement, or by a macro
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
// +  tzc::Publisher pub = tzc::advertise<std_msgs::Float32MultiArray>(nh, "values", 10);
