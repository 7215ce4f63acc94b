// A Point has no array: it is data as a number is, and what an algorithm is given names no message.
#include <algorithm>

#include <ros/ros.h>
#include <visualization_msgs/Marker.h>

void step(ros::NodeHandle& nh, const std::vector<geometry_msgs::Point>& source) {
  ros::Publisher pub = nh.advertise<visualization_msgs::Marker>("marker", 1);
  for (int turn = 0; turn < 2; ++turn) {
    visualization_msgs::Marker marker;
    marker.points.resize(source.size());
    std::copy(source.begin(), source.end(), marker.points.begin());
    for (std::size_t i = 0; i < source.size(); ++i) marker.points[i].x = i;
    pub.publish(marker);
  }
}
//--- expected
// advertise src/node.cpp:8 visualization_msgs/Marker zero_copy 'marker'
// publish src/node.cpp:14 visualization_msgs/Marker zero_copy 'marker'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/visualization_msgs/Marker.h>
// -  ros::Publisher pub = nh.advertise<visualization_msgs::Marker>("marker", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::visualization_msgs::Marker>(nh, "marker", 1);
// -    visualization_msgs::Marker marker;
// +    tzc::visualization_msgs::Marker marker;
// +    pub.allocate(marker);
