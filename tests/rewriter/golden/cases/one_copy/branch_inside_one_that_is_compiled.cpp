// One file compiles what is around the branch, no file the branch itself.
#define WITH_STEP
#include "node.h"

void open(ros::NodeHandle& nh) { pub = nh.advertise<sensor_msgs::Image>("image", 10); }
//--- src/other.cpp
#include "node.h"

int main() {}
//--- src/node.h
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#ifdef WITH_STEP
ros::Publisher pub;

void step() {
  sensor_msgs::Image image;
  image.data.resize(10);
#ifdef KEEP
  keep(image.data);
#endif
  pub.publish(image);
}
#endif
//--- expected
// advertise src/node.cpp:5 sensor_msgs/Image one_copy 'image'
// publish src/node.h:13 sensor_msgs/Image one_copy 'image' TZC3007 a preprocessor branch that is not compiled here names 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -void open(ros::NodeHandle& nh) { pub = nh.advertise<sensor_msgs::Image>("image", 10); }
// +void open(ros::NodeHandle& nh) { pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10); }
//
// +++ src/node.h
// +#include <tzc/ros.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
