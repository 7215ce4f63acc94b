// A class template of the package holds the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class T>
struct Holder {
  T value;
};

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
  Holder<sensor_msgs::Image> holder{image};
  pub.publish(holder.value);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1009 ported, it would not compile: no type named 'Stock' in 'sensor_msgs::Image_<std::allocator<void>>'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
