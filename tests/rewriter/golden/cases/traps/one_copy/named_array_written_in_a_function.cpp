// A function that is given the array twice, and one that is given it by pointer.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class Pixels>
int mark(Pixels& pixels, const Pixels& read) {
  const auto* first = read.data();
  pixels[0] = 1;
  return *first;
}

template <class Pixels>
void clear_first(Pixels* pixels) {
  (*pixels)[0] = 0;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("twice", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  pub.publish(image);
  image.width = mark(image.data, image.data);
  pub.publish(image);
}

void run_by_pointer(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("pointer", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  pub.publish(image);
  const sensor_msgs::Image& read = image;
  const uint8_t* first = &read.data[0];
  clear_first(&image.data);
  image.width = *first;
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:18 sensor_msgs/Image one_copy 'twice'
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'twice' TZC1003 'first' points into its data and is used after its data was written to
// publish src/node.cpp:23 sensor_msgs/Image one_copy 'twice' TZC1003 'first' points into its data and is used after its data was written to
// advertise src/node.cpp:27 sensor_msgs/Image one_copy 'pointer'
// publish src/node.cpp:30 sensor_msgs/Image one_copy 'pointer' TZC1003 'first' points into its data and is used after its data was written to
// publish src/node.cpp:35 sensor_msgs/Image one_copy 'pointer' TZC1003 'first' points into its data and is used after its data was written to
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("twice", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "twice", 10);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("pointer", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "pointer", 10);
