// A function template gets one closure and another.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

template <class Callback>
void for_each_pixel(const sensor_msgs::Image& image, Callback callback) {
  for (std::size_t i = 0; i < image.data.size(); ++i) callback(i, image.data[i]);
}
int brightest(const sensor_msgs::Image& image) {
  int most = 0;
  for_each_pixel(image, [&](std::size_t, int value) { most = std::max(most, value); });
  return most;
}
int darkest(const sensor_msgs::Image& image) {
  int least = 255;
  for_each_pixel(image, [&](std::size_t, int value) { least = std::min(least, value); });
  return least;
}

ros::Publisher pub;

void on_image(const sensor_msgs::ImageConstPtr& in) {
  sensor_msgs::Image out;
  out.data.resize(in->data.size());
  const int low = darkest(*in), high = brightest(*in);
  for (std::size_t i = 0; i < in->data.size(); ++i)
    out.data[i] = 255 * (in->data[i] - low) / (high - low + 1);
  pub.publish(out);
}
void run(ros::NodeHandle& nh) {
  pub = nh.advertise<sensor_msgs::Image>("out", 5);
  ros::Subscriber sub = nh.subscribe("in", 5, on_image);
  ros::spin();
}
//--- expected
// publish src/node.cpp:30 sensor_msgs/Image zero_copy 'out'
// advertise src/node.cpp:33 sensor_msgs/Image zero_copy 'out'
// subscribe src/node.cpp:34 sensor_msgs/Image shared 'in'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  sensor_msgs::Image out;
// +  tzc::sensor_msgs::Image out;
// +  pub.allocate(out);
// -  pub = nh.advertise<sensor_msgs::Image>("out", 5);
// -  ros::Subscriber sub = nh.subscribe("in", 5, on_image);
// +  pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "out", 5);
// +  ros::Subscriber sub = tzc::subscribe(nh, "in", 5, on_image);
