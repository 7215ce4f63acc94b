// A stream of the package may keep a pointer to what it is given.
#include <ros/ros.h>
#include <ros/serialization.h>
#include <sensor_msgs/Image.h>

struct Stream {
  const void* kept = nullptr;
};

void run(ros::NodeHandle& nh, Stream& stream, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(n);
  ros::serialization::serialize(stream, image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1002 it is passed to 'ros::serialization::serialize', which is not part of the package
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
