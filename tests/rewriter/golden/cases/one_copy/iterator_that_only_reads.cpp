// Deduced, the iterator would let write: another overload might be called with what it points to.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

int look(const uint8_t&) { return 0; }
int look(uint8_t& byte) { return byte = 1; }

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(n);
  for (std::vector<uint8_t>::const_iterator byte = image.data.begin(); byte != image.data.end(); ++byte) look(*byte);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1009 ported, it would not compile: no viable conversion from 'unsigned char *' to 'std::vector<uint8_t>::const_iterator' (aka '__normal_iterator<const unsigned char *, std::vector<unsigned char, std::allocator<unsigned char>>>')
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
