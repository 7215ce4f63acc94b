// toImageMsg in a free function that does not know the publisher.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>

sensor_msgs::ImagePtr make() { return cv_bridge::CvImage().toImageMsg(); }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  pub.publish(make());
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image one_copy 'image' TZC1019 it is built where its publisher cannot be named: 'pub' is a variable of another function
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
