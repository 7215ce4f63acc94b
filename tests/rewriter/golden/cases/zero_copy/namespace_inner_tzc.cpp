// A package with a namespace company::tzc.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

namespace company {
namespace tzc {
struct Publisher {};
void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  pub.publish(image);
}
}  // namespace tzc
}  // namespace company
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  ::tzc::Publisher pub = ::tzc::advertise<::tzc::sensor_msgs::Image>(nh, "image", 10);
// +  ::tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
