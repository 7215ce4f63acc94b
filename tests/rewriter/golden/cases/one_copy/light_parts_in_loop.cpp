// Each part is light, their number is not known.
//RUN: small=4096
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<visualization_msgs::MarkerArray>("markers", 10);
  visualization_msgs::MarkerArray pushed;
  for (int i = 0; i < n; ++i) {
    visualization_msgs::Marker marker;
    marker.points.resize(10);
    pushed.markers.push_back(marker);
  }
  pub.publish(pushed);
  visualization_msgs::MarkerArray resized;
  resized.markers.resize(n);
  for (int i = 0; i < n; ++i) resized.markers[i].points.resize(10);
  pub.publish(resized);
}
//--- expected
// advertise src/node.cpp:7 visualization_msgs/MarkerArray one_copy 'markers'
// publish src/node.cpp:14 visualization_msgs/MarkerArray one_copy 'markers' TZC1018 its arrays lie inside an array of messages
// publish src/node.cpp:18 visualization_msgs/MarkerArray one_copy 'markers' TZC1018 its arrays lie inside an array of messages
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<visualization_msgs::MarkerArray>("markers", 10);
// +  tzc::Publisher pub = tzc::advertise<visualization_msgs::MarkerArray>(nh, "markers", 10);
