// Code of another package builds the message.
#include <other/library.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image = other::grab();
  pub.publish(image);
  pub.publish(other::grab());
  sensor_msgs::ImagePtr shared = other::grab_shared();
  pub.publish(shared);
}
//--- expected
// advertise src/node.cpp:5 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:7 sensor_msgs/Image one_copy 'image' TZC1013 it starts as 'other::grab()', which code outside the package builds
// publish src/node.cpp:8 sensor_msgs/Image one_copy 'image' TZC1013 code outside the package builds the message
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1013 it starts as 'other::grab_shared()', which code outside the package builds
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
