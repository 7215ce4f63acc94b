// Structured bindings of a struct of pointers.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Row {
  uint8_t *begin, *end;
};

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  auto [first, last] = Row{&image.data[0], &image.data[10]};
  pub.publish(image);
  *first = 1;
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data becomes part of an aggregate
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
