// What would not compile is left: the program has a name of TZC's.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

namespace tzc {
int subscribe = 0;
}

void callback(const sensor_msgs::ImageConstPtr&) {}

void run(ros::NodeHandle& nh) {
  ros::Subscriber sub = nh.subscribe("image", 1, callback);
}
//--- expected
// subscribe src/node.cpp:12 sensor_msgs/Image plain 'image' TZC2005 ported, it would not compile: redefinition of 'subscribe' as different kind of symbol
