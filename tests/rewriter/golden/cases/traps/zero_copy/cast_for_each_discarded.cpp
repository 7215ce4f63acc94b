// for_each with a closure, on the spot.
#include <algorithm>
#include <iterator>
#include <utility>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  uint8_t* first = &image.data[0];
  std::vector<int> numbers(1);
  std::for_each(numbers.begin(), numbers.end(), [first](int n) { *first = n; });
  pub.publish(image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
