// toImageMsg in a free function that does not know the publisher.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>

sensor_msgs::ImagePtr make() { return cv_bridge::CvImage().toImageMsg(); }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  pub.publish(make());
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::ImagePtr make() { return cv_bridge::CvImage().toImageMsg(); }
// +tzc::sensor_msgs::ImagePtr make(const tzc::Publisher& publisher) { return tzc::cv_bridge::to_image_msg(cv_bridge::CvImage(), publisher); }
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  pub.publish(make());
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  pub.publish(make(pub));
