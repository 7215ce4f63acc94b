// By a converting constructor.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Span {
  Span(uint8_t* p) : first(p) {}
  uint8_t* first;
};

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  Span span = &image.data[0];
  pub.publish(image);
  *span.first = 1;
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in a member
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
