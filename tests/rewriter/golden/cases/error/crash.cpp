// What crashes Clang, or the analysis, is one unit's matter: the run goes on and names it. GCC does not know this pragma.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#pragma clang __debug llvm_fatal_error

void run(ros::NodeHandle& nh) { nh.advertise<sensor_msgs::Image>("image", 1); }
//--- expected
// error tzc-rewrite crashed on it (Aborted)
