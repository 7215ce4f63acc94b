// The elements come from another vector.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>
#include <algorithm>
#include <iterator>
#include <vector>

void run(ros::NodeHandle& nh, std::vector<float> input) {
  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
  std_msgs::Float32MultiArray swapped;
  swapped.data.swap(input);
  pub.publish(swapped);
  std_msgs::Float32MultiArray given;
  input.swap(given.data);
  pub.publish(given);
  std_msgs::Float32MultiArray exchanged;
  std::swap(exchanged.data, input);
  pub.publish(exchanged);
  std_msgs::Float32MultiArray moved;
  moved.data = std::move(input);
  pub.publish(moved);
  std_msgs::Float32MultiArray inserted;
  inserted.data.insert(inserted.data.end(), input.begin(), input.end());
  pub.publish(inserted);
  std_msgs::Float32MultiArray filled;
  std::copy(input.begin(), input.end(), std::back_inserter(filled.data));
  pub.publish(filled);
}
//--- expected
// advertise src/node.cpp:10 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:13 std_msgs/Float32MultiArray one_copy 'values' TZC1003 a pointer into its data is passed to 'std::swap'
// publish src/node.cpp:16 std_msgs/Float32MultiArray one_copy 'values' TZC1003 a pointer into its data is passed to 'std::swap'
// publish src/node.cpp:19 std_msgs/Float32MultiArray one_copy 'values' TZC1003 a pointer into its data is passed to 'std::swap'
// publish src/node.cpp:22 std_msgs/Float32MultiArray one_copy 'values' TZC1003 a pointer into its data may exist: 'input' gives its elements more than once
// publish src/node.cpp:25 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:28 std_msgs/Float32MultiArray zero_copy 'values'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/std_msgs/Float32MultiArray.h>
// -  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::std_msgs::Float32MultiArray>(nh, "values", 10);
// -  std_msgs::Float32MultiArray inserted;
// +  tzc::std_msgs::Float32MultiArray inserted;
// +  pub.allocate(inserted);
// -  std_msgs::Float32MultiArray filled;
// +  tzc::std_msgs::Float32MultiArray filled;
// +  pub.allocate(filled);
