// As a shared_ptr that does not own it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <memory>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::shared_ptr<uint8_t> first(&image.data[0], [](uint8_t*) {});
  pub.publish(image);
  *first = 1;
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in a 'std::shared_ptr'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
