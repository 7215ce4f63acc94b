// A value that has a pointer among the members of a union.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct View {
  union {
    uint8_t* bytes;
    std::size_t number;
  } where;
};

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(n);
  const View view{{&image.data[0]}};
  pub.publish(image);
  *view.where.bytes = 1;
}
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data becomes part of an aggregate
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
