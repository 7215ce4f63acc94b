// The array is swapped with a vector.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  std::vector<uint8_t> pixels(100, 1);
  sensor_msgs::Image image;
  image.data.swap(pixels);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1022 line 9 gives it elements that lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
