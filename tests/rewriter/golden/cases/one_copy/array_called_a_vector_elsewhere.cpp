// A parameter and a member say that they are vectors: other callers and constructors rely on it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void fill(std::vector<uint8_t>& bytes) { bytes.assign(10, 1); }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  fill(image.data);
  pub.publish(image);
  std::vector<uint8_t> own;
  fill(own);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1009 ported, it would not compile: no matching function for call to 'fill'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
