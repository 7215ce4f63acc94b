// A static of a template for each type.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class M>
int count(const M&) {
  static int calls = 0;
  return ++calls;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  image.height = count(image);
  image.height += count(sensor_msgs::Image());
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1001 'count' asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
