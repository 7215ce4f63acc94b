// A pointer into the vector that becomes the array.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::vector<uint8_t> pixels(100, 1);
  uint8_t* first = &pixels[0];
  image.data.swap(pixels);
  *first = 2;
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
