// The unit's closures have nothing to do with its subscription.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class F>
int count(int end, F f) {
  int found = 0;
  for (int i = 0; i < end; ++i) found += f(i) ? 1 : 0;
  return found;
}
void on_image(const sensor_msgs::ImageConstPtr& in) {
  struct {
    int threshold;
  } const limits = {count(100, [](int i) { return i % 3 == 0; })};
  const int bright = count(static_cast<int>(in->data.size()), [&](int i) { return in->data[i] > limits.threshold; });
  ROS_INFO("%d", bright);
}
void run(ros::NodeHandle& nh) {
  ros::Subscriber sub = nh.subscribe("in", 5, on_image);
  ros::spin();
}
//--- expected
// subscribe src/node.cpp:19 sensor_msgs/Image shared 'in'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber sub = nh.subscribe("in", 5, on_image);
// +  ros::Subscriber sub = tzc::subscribe(nh, "in", 5, on_image);
