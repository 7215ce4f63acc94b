// A call that would choose another overload.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void touch(std::vector<uint8_t>& data) { data.clear(); }
template <class T>
void touch(T& data) { data[0] = 1; }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
  touch(image.data);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1009 ported, this call would choose another 'touch' than before
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
