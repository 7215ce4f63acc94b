// A macro that writes nothing but its argument, the call: what stands in the file is the macro's name.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define SAME(x) x
#define TOPIC "image"

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = SAME(nh.advertise<sensor_msgs::Image>("image", 10));
  ros::Publisher other = SAME(nh.advertise<sensor_msgs::Image>(TOPIC, 10));
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image' TZC1006 the advertise call comes from a macro
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1006 the advertise call comes from a macro
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = SAME(nh.advertise<sensor_msgs::Image>("image", 10));
// -  ros::Publisher other = SAME(nh.advertise<sensor_msgs::Image>(TOPIC, 10));
// +  ros::Publisher pub = tzc::attached<sensor_msgs::Image>(SAME(nh.advertise<sensor_msgs::Image>("image", 10)));
// +  ros::Publisher other = tzc::attached<sensor_msgs::Image>(SAME(nh.advertise<sensor_msgs::Image>(TOPIC, 10)));
