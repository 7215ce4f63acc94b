// A template of the array.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class T>
int is_vector(const T&) {
  return 0;
}
template <class T>
int is_vector(const std::vector<T>&) {
  return 1;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  image.height = is_vector(image.data);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1009 ported, this call would choose another 'is_vector' than before
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
