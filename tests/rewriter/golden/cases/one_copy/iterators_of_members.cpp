// Iterators that are named through a vector of messages, or through the message that has one.
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) { pub_ = nh.advertise<visualization_msgs::Marker>("markers", 1); }
  void tick() {
    for (std::vector<visualization_msgs::Marker>::iterator marker = markers_.begin(); marker != markers_.end(); ++marker) {
      marker->points.clear();
      marker->points.resize(100);
      pub_.publish(*marker);
    }
    for (visualization_msgs::MarkerArray::_markers_type::const_iterator marker = markers_.begin();
         marker != markers_.end(); ++marker)
      pub_.publish(*marker);
  }

 private:
  ros::Publisher pub_;
  std::vector<visualization_msgs::Marker> markers_;
};
//--- expected
// advertise src/node.cpp:7 visualization_msgs/Marker one_copy 'markers'
// publish src/node.cpp:12 visualization_msgs/Marker one_copy 'markers' TZC1022 line 14 of node.cpp uses a visualization_msgs/Marker, and nothing shows which: it may be this one, and be written to after this publish
// publish src/node.cpp:16 visualization_msgs/Marker one_copy 'markers' TZC1022 line 14 of node.cpp uses a visualization_msgs/Marker, and nothing shows which: it may be this one, and be written to after this publish
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/visualization_msgs/Marker.h>
// +#include <tzc/visualization_msgs/MarkerArray.h>
// -  explicit Node(ros::NodeHandle& nh) { pub_ = nh.advertise<visualization_msgs::Marker>("markers", 1); }
// +  explicit Node(ros::NodeHandle& nh) { pub_ = tzc::advertise<tzc::visualization_msgs::Marker>(nh, "markers", 1); }
// -    for (std::vector<visualization_msgs::Marker>::iterator marker = markers_.begin(); marker != markers_.end(); ++marker) {
// +    for (std::vector<tzc::visualization_msgs::Marker>::iterator marker = markers_.begin(); marker != markers_.end(); ++marker) {
// -    for (visualization_msgs::MarkerArray::_markers_type::const_iterator marker = markers_.begin();
// +    for (tzc::visualization_msgs::MarkerArray::_markers_type::const_iterator marker = markers_.begin();
// -  ros::Publisher pub_;
// -  std::vector<visualization_msgs::Marker> markers_;
// +  tzc::Publisher pub_;
// +  std::vector<tzc::visualization_msgs::Marker> markers_;
