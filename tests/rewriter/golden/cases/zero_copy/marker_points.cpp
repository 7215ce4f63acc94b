// A marker with points.
#include <ros/ros.h>
#include <visualization_msgs/Marker.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<visualization_msgs::Marker>("image", 10);
  visualization_msgs::Marker marker;
  geometry_msgs::Point p;
  marker.points.push_back(p);
  pub.publish(marker);
}
//--- expected
// advertise src/node.cpp:6 visualization_msgs/Marker zero_copy 'image'
// publish src/node.cpp:10 visualization_msgs/Marker zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/visualization_msgs/Marker.h>
// -  ros::Publisher pub = nh.advertise<visualization_msgs::Marker>("image", 10);
// -  visualization_msgs::Marker marker;
// +  tzc::Publisher pub = tzc::advertise<tzc::visualization_msgs::Marker>(nh, "image", 10);
// +  tzc::visualization_msgs::Marker marker;
// +  pub.allocate(marker);
