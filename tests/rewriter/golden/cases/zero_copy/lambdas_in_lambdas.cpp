// Closures in closures, in a template, and generic ones, all given to one template.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class F>
void repeat(int times, F f) {
  for (int i = 0; i < times; ++i) f(i);
}
template <class F>
void twice(F f) {
  repeat(2, [&](int i) { f(i); });
  repeat(2, [&](int i) { f(-i); });
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("out", 5);
  int sum = 0;
  const auto add = [&](auto number) { sum += static_cast<int>(number); };
  repeat(3, [&](int row) {
    repeat(4, [&](int column) { repeat(4, [&](int i) { sum += row * column + i; }); });
    twice([&](int i) { add(i); });
    twice([&](long i) { add(i); });
  });
  sensor_msgs::Image out;
  out.data.resize(sum);
  pub.publish(out);
}
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'out'
// publish src/node.cpp:26 sensor_msgs/Image zero_copy 'out'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("out", 5);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "out", 5);
// -  sensor_msgs::Image out;
// +  tzc::sensor_msgs::Image out;
// +  pub.allocate(out);
