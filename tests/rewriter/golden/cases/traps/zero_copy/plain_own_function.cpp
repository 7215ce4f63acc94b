// A function of the package whose body is followed.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void draw(uint8_t* pixels, int n) {
  for (int i = 0; i < n; ++i) pixels[i] = i;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  draw(image.data.data(), 100);
  pub.publish(image);
  image.height = 2;
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
