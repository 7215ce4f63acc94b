// A class template of the package holds the message: nothing in the template says its type.
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
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1005 its type is the parameter 'T' of a class template
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
