// A preprocessor branch that is not compiled is reported; as it publishes the message, that keeps its type.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
#ifdef USE_OTHER
  ros::Publisher other = nh.advertise<sensor_msgs::Image>("other", 1);
  other.publish(image);
#endif
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC3007 a preprocessor branch that is not compiled here names 'image'
// note src/node.cpp:9 TZC3002
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
