// A preprocessor branch that is not compiled is reported; it has nothing to do with the port.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
#ifdef USE_OTHER
  ros::Publisher other = nh.advertise<sensor_msgs::Image>("other", 1);
  other.publish(sensor_msgs::Image());
#endif
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// note src/node.cpp:7 TZC3002
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
