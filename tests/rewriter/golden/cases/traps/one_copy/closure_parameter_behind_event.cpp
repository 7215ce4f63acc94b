// Within one call of the closure its parameter is used behind a publish: in the order of the source, and in a loop of the closure.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

void in_order(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("in_order", 10);
  while (ros::ok()) {
    sensor_msgs::Image image;
    image.data.resize(100, 1);
    std::for_each(image.data.begin(), image.data.end(), [&](uint8_t& x) {
      pub.publish(image);
      x += 3;
    });
  }
}
void in_loop(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("in_loop", 10);
  sensor_msgs::Image image;
  image.data.resize(100, 1);
  std::for_each(image.data.begin(), image.data.end(), [&](uint8_t& x) {
    for (int i = 0; i < 2; ++i) {
      x += 3;
      pub.publish(image);
    }
  });
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'in_order'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'in_order' TZC1003 'x' points into its data and is used after the message may have been published
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'in_loop'
// publish src/node.cpp:25 sensor_msgs/Image one_copy 'in_loop' TZC1003 'x' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("in_order", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "in_order", 10);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("in_loop", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "in_loop", 10);
