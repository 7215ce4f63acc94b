// A list of two iterators is a range, a list of two pointers is two elements, where the build does not mind that they are narrowed.
#pragma GCC diagnostic ignored "-Wnarrowing"
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <vector>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::vector<bool> mask{image.data.begin(), image.data.end()};
  image.width = mask.size();
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1009 ported, this call would choose another 'std::vector::vector' than before
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
