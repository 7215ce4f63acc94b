// The size changes through a pointer, a reference, a const_cast, a capture or a function.
//RUN: small=4096
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>

void grow(std::vector<float>& values) {
  values.resize(100000);
}
void grow_const(const std::vector<float>& values) {
  const_cast<std::vector<float>&>(values).resize(100000);
}

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
  std_msgs::Float32MultiArray referred;
  std::vector<float>& reference = referred.data;
  reference.resize(n);
  pub.publish(referred);
  std_msgs::Float32MultiArray pointed;
  std::vector<float>* pointer = &pointed.data;
  pointer->resize(n);
  pub.publish(pointed);
  std_msgs::Float32MultiArray passed;
  grow(passed.data);
  pub.publish(passed);
  std_msgs::Float32MultiArray passed_const;
  grow_const(passed_const.data);
  pub.publish(passed_const);
  std_msgs::Float32MultiArray cast;
  const std::vector<float>& kept = cast.data;
  const_cast<std::vector<float>&>(kept).resize(n);
  pub.publish(cast);
  std_msgs::Float32MultiArray captured;
  [&values = captured.data](int size) { values.resize(size); }(n);
  pub.publish(captured);
}
//--- expected
// advertise src/node.cpp:14 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:18 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:22 std_msgs/Float32MultiArray zero_copy 'values'
// publish src/node.cpp:25 std_msgs/Float32MultiArray one_copy 'values' TZC1009 ported, it would not compile: no matching function for call to 'grow'
// publish src/node.cpp:28 std_msgs/Float32MultiArray one_copy 'values' TZC1003 a pointer into its data is cast to 'std::vector<float> &', which its array is not in the port
// publish src/node.cpp:32 std_msgs/Float32MultiArray one_copy 'values' TZC1003 a pointer into its data is cast to 'std::vector<float> &', which its array is not in the port
// publish src/node.cpp:35 std_msgs/Float32MultiArray one_copy 'values' TZC1003 a pointer into its data is held by a closure
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/std_msgs/Float32MultiArray.h>
// -  ros::Publisher pub = nh.advertise<std_msgs::Float32MultiArray>("values", 10);
// -  std_msgs::Float32MultiArray referred;
// -  std::vector<float>& reference = referred.data;
// +  tzc::Publisher pub = tzc::advertise<tzc::std_msgs::Float32MultiArray>(nh, "values", 10);
// +  tzc::std_msgs::Float32MultiArray referred;
// +  pub.allocate(referred);
// +  auto& reference = referred.data;
// -  std_msgs::Float32MultiArray pointed;
// -  std::vector<float>* pointer = &pointed.data;
// +  tzc::std_msgs::Float32MultiArray pointed;
// +  pub.allocate(pointed);
// +  auto* pointer = &pointed.data;
