// A package that does not compile.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) { nh.advertize("image"); }
//--- expected
// error does not parse: no member named 'advertize' in 'ros::NodeHandle'
