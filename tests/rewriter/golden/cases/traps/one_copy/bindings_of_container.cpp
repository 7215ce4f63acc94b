// Structured bindings of a container of messages.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <map>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::map<int, sensor_msgs::Image> images;
  images[0] = image;
  for (auto& [index, one] : images) {
    auto* first = &one.data[0];
    pub.publish(one);
    *first = 1;
  }
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
