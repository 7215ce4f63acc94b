// A container that hides behind a typedef of the package.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

typedef std::vector<sensor_msgs::Image> Images;

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  Images images(3);
  images[0].data.resize(10);
  pub.publish(images[0]);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1005 its type hides behind the name 'Images'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
