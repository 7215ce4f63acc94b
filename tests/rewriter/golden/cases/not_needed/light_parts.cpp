// A message whose only arrays belong to two calibrations.
//RUN: small=4096
#include <ros/ros.h>
#include <vendor_msgs/Rig.h>

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<vendor_msgs::Rig>("rig", 10);
  vendor_msgs::Rig rig;
  rig.left.D.resize(n);
  pub.publish(rig);
}
//--- expected
// advertise src/node.cpp:7 vendor_msgs/Rig not_needed 'rig' its arrays are light by their type
// publish src/node.cpp:10 vendor_msgs/Rig not_needed 'rig' its arrays are light by their type
