// A function fills markers of their own and those of an array: both are ported, the array's arrays lie inside its elements.
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

class Display {
 public:
  Display() {
    line_pub_ = nh_.advertise<visualization_msgs::Marker>("line", 1);
    all_pub_ = nh_.advertise<visualization_msgs::MarkerArray>("all", 1);
  }
  void show() {
    visualization_msgs::Marker line;
    setMarker(line, 1);
    line.points.resize(10000);
    line_pub_.publish(line);
    visualization_msgs::Marker first;
    setMarker(first, 2);
    first.points.resize(10);
    visualization_msgs::MarkerArray all;
    all.markers.push_back(first);
    all.markers.resize(3);
    setMarker(all.markers[2], 3);
    all_pub_.publish(all);
  }

 private:
  void setMarker(visualization_msgs::Marker& marker, int id) { marker.header.seq = id; }
  ros::NodeHandle nh_;
  ros::Publisher line_pub_, all_pub_;
};
//--- expected
// advertise src/node.cpp:8 visualization_msgs/Marker zero_copy 'line'
// advertise src/node.cpp:9 visualization_msgs/MarkerArray one_copy 'all'
// publish src/node.cpp:15 visualization_msgs/Marker zero_copy 'line'
// publish src/node.cpp:23 visualization_msgs/MarkerArray one_copy 'all' TZC1018 its arrays lie inside an array of messages
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/visualization_msgs/Marker.h>
// +#include <tzc/visualization_msgs/MarkerArray.h>
// -    line_pub_ = nh_.advertise<visualization_msgs::Marker>("line", 1);
// -    all_pub_ = nh_.advertise<visualization_msgs::MarkerArray>("all", 1);
// +    line_pub_ = tzc::advertise<tzc::visualization_msgs::Marker>(nh_, "line", 1);
// +    all_pub_ = tzc::advertise<tzc::visualization_msgs::MarkerArray>(nh_, "all", 1);
// -    visualization_msgs::Marker line;
// +    tzc::visualization_msgs::Marker line;
// +    line_pub_.allocate(line);
// -    visualization_msgs::Marker first;
// +    tzc::visualization_msgs::Marker first;
// -    visualization_msgs::MarkerArray all;
// +    tzc::visualization_msgs::MarkerArray all;
// -  void setMarker(visualization_msgs::Marker& marker, int id) { marker.header.seq = id; }
// +  void setMarker(tzc::visualization_msgs::Marker& marker, int id) { marker.header.seq = id; }
// -  ros::Publisher line_pub_, all_pub_;
// +  tzc::Publisher line_pub_, all_pub_;
