// for_each returns the closure, which is called after the publish.
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
  auto again = std::for_each(numbers.begin(), numbers.end(), [first](int n) { *first = n; });
  pub.publish(image);
  again(3);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is held by a closure
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is held by a closure
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
