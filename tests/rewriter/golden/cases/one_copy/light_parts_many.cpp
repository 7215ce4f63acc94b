// Fifty calibrations, and any number of them: the bound of one says nothing.
//RUN: small=4096
#include <ros/ros.h>
#include <vendor_msgs/Rig.h>

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher fixed = nh.advertise<vendor_msgs::FiftyRigs>("fifty", 10);
  vendor_msgs::FiftyRigs fifty;
  fifty.rigs[0].left.D.resize(n);
  fixed.publish(fifty);
  ros::Publisher any = nh.advertise<vendor_msgs::ManyRigs>("many", 10);
  vendor_msgs::ManyRigs many;
  many.rigs.resize(n);
  any.publish(many);
}
//--- expected
// advertise src/node.cpp:7 vendor_msgs/FiftyRigs one_copy 'fifty'
// publish src/node.cpp:10 vendor_msgs/FiftyRigs one_copy 'fifty' TZC4004 'vendor_msgs/FiftyRigs' has no TZC header
// advertise src/node.cpp:11 vendor_msgs/ManyRigs one_copy 'many'
// publish src/node.cpp:14 vendor_msgs/ManyRigs one_copy 'many' TZC4004 'vendor_msgs/ManyRigs' has no TZC header
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher fixed = nh.advertise<vendor_msgs::FiftyRigs>("fifty", 10);
// +  tzc::Publisher fixed = tzc::advertise<vendor_msgs::FiftyRigs>(nh, "fifty", 10);
// -  ros::Publisher any = nh.advertise<vendor_msgs::ManyRigs>("many", 10);
// +  tzc::Publisher any = tzc::advertise<vendor_msgs::ManyRigs>(nh, "many", 10);
