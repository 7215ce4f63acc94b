// A closure that takes any type is followed as each of its instances.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

sensor_msgs::Image kept;
void lasting(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("lasting", 1);
  const auto fill = [](auto& image) { image.data[0] = 1; };
  fill(kept);
  pub.publish(kept);
}
void fresh(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("fresh", 1);
  sensor_msgs::Image image;
  const auto fill = [](auto& image) { image.data.resize(100); };
  fill(image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'lasting'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'lasting' TZC1022 line 8 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'fresh'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'fresh'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::Image kept;
// +tzc::sensor_msgs::Image kept;
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("lasting", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "lasting", 1);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("fresh", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "fresh", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
