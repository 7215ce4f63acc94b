// New elements of a message's array have no memory, and each of them is published alone, too.
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

class Node {
 public:
  Node() {
    one_ = nh_.advertise<visualization_msgs::Marker>("one", 1);
    two_ = nh_.advertise<visualization_msgs::Marker>("two", 1);
    all_ = nh_.advertise<visualization_msgs::MarkerArray>("all", 1);
  }
  void resized() {
    resized_.markers.resize(resized_.markers.size() + 1);
    resized_.markers.back().points.assign(20000, geometry_msgs::Point());
    one_.publish(resized_.markers.back());
    all_.publish(resized_);
  }
  void pushed() {
    pushed_.markers.push_back(visualization_msgs::Marker());
    pushed_.markers[0].points.assign(20000, geometry_msgs::Point());
    two_.publish(pushed_.markers[0]);
    all_.publish(pushed_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher one_, two_, all_;
  visualization_msgs::MarkerArray resized_, pushed_;
};
//--- expected
// advertise src/node.cpp:8 visualization_msgs/Marker one_copy 'one'
// advertise src/node.cpp:9 visualization_msgs/Marker one_copy 'two'
// advertise src/node.cpp:10 visualization_msgs/MarkerArray one_copy 'all'
// publish src/node.cpp:15 visualization_msgs/Marker one_copy 'one' TZC1022 line 13 gives it elements that lie outside shared memory
// publish src/node.cpp:16 visualization_msgs/MarkerArray one_copy 'all' TZC1018 its arrays lie inside an array of messages
// publish src/node.cpp:21 visualization_msgs/Marker one_copy 'two' TZC1022 line 19 gives it elements that lie outside shared memory
// publish src/node.cpp:22 visualization_msgs/MarkerArray one_copy 'all' TZC1018 its arrays lie inside an array of messages
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/visualization_msgs/Marker.h>
// +#include <tzc/visualization_msgs/MarkerArray.h>
// -    one_ = nh_.advertise<visualization_msgs::Marker>("one", 1);
// -    two_ = nh_.advertise<visualization_msgs::Marker>("two", 1);
// -    all_ = nh_.advertise<visualization_msgs::MarkerArray>("all", 1);
// +    one_ = tzc::advertise<tzc::visualization_msgs::Marker>(nh_, "one", 1);
// +    two_ = tzc::advertise<tzc::visualization_msgs::Marker>(nh_, "two", 1);
// +    all_ = tzc::advertise<tzc::visualization_msgs::MarkerArray>(nh_, "all", 1);
// -    pushed_.markers.push_back(visualization_msgs::Marker());
// +    pushed_.markers.push_back(tzc::visualization_msgs::Marker());
// -  ros::Publisher one_, two_, all_;
// -  visualization_msgs::MarkerArray resized_, pushed_;
// +  tzc::Publisher one_, two_, all_;
// +  tzc::visualization_msgs::MarkerArray resized_, pushed_;
