// using declaration and typedef.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

using sensor_msgs::Image;
typedef sensor_msgs::Image Picture;

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  Image image;
  Picture picture;
  Picture::Ptr shared(new Picture);
  image.data.resize(1);
  picture.data.resize(1);
  shared->data.resize(1);
  pub.publish(image);
  pub.publish(picture);
  pub.publish(shared);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  Image image;
// -  Picture picture;
// -  Picture::Ptr shared(new Picture);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// +  tzc::sensor_msgs::Image picture;
// +  pub.allocate(picture);
// +  tzc::sensor_msgs::ImagePtr shared(new tzc::sensor_msgs::Image);
// +  pub.allocate(*shared);
