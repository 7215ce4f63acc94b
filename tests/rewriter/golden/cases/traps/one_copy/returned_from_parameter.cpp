// A function returns a pointer into what it is given.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

uint8_t* first_of(sensor_msgs::Image& image) {
  return &image.data[0];
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  uint8_t* first = first_of(image);
  pub.publish(image);
  *first = 1;
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is returned
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
