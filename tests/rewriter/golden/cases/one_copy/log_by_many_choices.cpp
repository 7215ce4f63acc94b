// References to choices between references: which stream the last one is, is not followed through all of them.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <iostream>

static uint8_t* raw;

void run(ros::NodeHandle& nh, bool left) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
#define TWICE(to, from) std::ostream& to = left ? from : from
  TWICE(a, std::cout);
  TWICE(b, a);
  TWICE(c, b);
  TWICE(d, c);
  TWICE(e, d);
  TWICE(f, e);
  TWICE(g, f);
  TWICE(h, g);
  TWICE(i, h);
  i << "sent" << 1;
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
