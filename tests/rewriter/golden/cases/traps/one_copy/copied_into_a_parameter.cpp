// A template takes a copy of the array, and asks for its type.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <type_traits>
#include <vector>

template <class T>
bool is_vector(T) {
  return std::is_same<T, std::vector<uint8_t>>::value;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  image.data[0] = is_vector(image.data);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data goes to 'is_vector', which asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
