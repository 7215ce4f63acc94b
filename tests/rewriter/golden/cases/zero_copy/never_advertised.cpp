// A publisher that is never advertised in the package.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void send(const ros::Publisher& pub) {
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//--- expected
// publish src/node.cpp:8 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  pub.publish(image);
// +  tzc::publish(pub, image);
