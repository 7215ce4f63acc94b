// All arrays lie inside an array of messages: one copy.
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<visualization_msgs::MarkerArray>("image", 10);
  visualization_msgs::MarkerArray markers;
  visualization_msgs::Marker marker;
  marker.points.resize(10);
  markers.markers.push_back(marker);
  pub.publish(markers);
}
//--- expected
// advertise src/node.cpp:6 visualization_msgs/MarkerArray one_copy 'image'
// publish src/node.cpp:11 visualization_msgs/MarkerArray one_copy 'image' TZC1018 its arrays lie inside an array of messages
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<visualization_msgs::MarkerArray>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<visualization_msgs::MarkerArray>(nh, "image", 10);
