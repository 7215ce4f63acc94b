// The message becomes part of an aggregate of the package.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  sensor_msgs::Image image;
  int n;
};

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
  Frame frame{image, 1};
  pub.publish(frame.image);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1009 ported, it would not compile: no viable conversion from 'sensor_msgs::Image' (aka 'Image_<std::allocator<void>>') to 'tzc::sensor_msgs::Image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
