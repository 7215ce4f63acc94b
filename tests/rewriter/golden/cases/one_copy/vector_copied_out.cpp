// The array is copied out into a vector.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
  std::vector<uint8_t> copy = image.data;
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1009 ported, it would not compile: no viable conversion from '::tzc::Array<uint8_t>' (aka 'Array<unsigned char>') to 'std::vector<uint8_t>' (aka 'vector<unsigned char>')
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
