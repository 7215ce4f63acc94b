// A message of another package that has no TZC headers: copied once, and its neighbours are ported all the same.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <vendor_msgs/Blob.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher blobs = nh.advertise<vendor_msgs::Blob>("blob", 10);
  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
  vendor_msgs::Blob blob;
  blob.data.resize(10);
  blobs.publish(blob);
  sensor_msgs::Image image;
  image.data.resize(10);
  images.publish(image);
}
//--- expected
// advertise src/node.cpp:7 vendor_msgs/Blob one_copy 'blob'
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 vendor_msgs/Blob one_copy 'blob' TZC4004 'vendor_msgs/Blob' has no TZC header
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -  ros::Publisher blobs = nh.advertise<vendor_msgs::Blob>("blob", 10);
// -  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher blobs = tzc::advertise<vendor_msgs::Blob>(nh, "blob", 10);
// +  tzc::Publisher images = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  images.allocate(image);
