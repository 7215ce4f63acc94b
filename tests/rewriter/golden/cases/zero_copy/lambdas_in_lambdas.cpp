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
    sensor_msgs::Image out;
    out.data.resize(16);
    repeat(4, [&](int column) { repeat(4, [&](int i) { out.data[4 * column + i] = row; }); });
    twice([&](int i) { add(i); });
    twice([&](long i) { add(i); });
    pub.publish(out);
  });
}
//--- expected
