// The call is itself the argument of a macro, also with macros for its own arguments: it is edited there.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define DO(x) do { x; } while (false)
#define TOPIC "image"
#define QUEUE 10

void run(ros::NodeHandle& nh) {
  ros::Publisher pub;
  DO(pub = nh.advertise<sensor_msgs::Image>("image", 10));
  DO(pub = nh.advertise<sensor_msgs::Image>(TOPIC, QUEUE));
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub;
// -  DO(pub = nh.advertise<sensor_msgs::Image>("image", 10));
// -  DO(pub = nh.advertise<sensor_msgs::Image>(TOPIC, QUEUE));
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub;
// +  DO(pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10));
// +  DO(pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, TOPIC, QUEUE));
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
