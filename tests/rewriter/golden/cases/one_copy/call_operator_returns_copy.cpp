// An object that is called returns a copy of the message that it refers to.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Get {
  const sensor_msgs::Image& image;
  sensor_msgs::Image operator()() const { return image; }
};

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  static sensor_msgs::Image image;
  image.data.resize(100);
  pub.publish(Get{image}());
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1022 it is a copy (made in line 7), whose elements lie outside shared memory until it is published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  const sensor_msgs::Image& image;
// -  sensor_msgs::Image operator()() const { return image; }
// +  const tzc::sensor_msgs::Image& image;
// +  tzc::sensor_msgs::Image operator()() const { return image; }
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  static sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  static tzc::sensor_msgs::Image image;
