// Its poses have strings, so no array of it lies in shared memory in place; but it may be long.
#include <nav_msgs/Path.h>
#include <ros/ros.h>

class Planner {
 public:
  explicit Planner(ros::NodeHandle& nh) {
    pub_ = nh.advertise<nav_msgs::Path>("plan", 1);
    sub_ = nh.subscribe("plan", 1, &Planner::received, this);
    sub_own_ = nh.subscribe("plan", 1, &Planner::received_as_own, this);
  }
  void local(int steps) {
    nav_msgs::Path path;
    path.poses.resize(steps);
    pub_.publish(path);
  }
  void member() {
    driven_->poses.emplace_back();
    pub_.publish(driven_);
  }
  void received(const nav_msgs::PathConstPtr& path) { pub_.publish(path); }
  void received_as_own(nav_msgs::Path path) { path.poses.clear(); }

 private:
  ros::Publisher pub_;
  ros::Subscriber sub_, sub_own_;
  nav_msgs::PathPtr driven_{new nav_msgs::Path};
};
//--- expected
// advertise src/node.cpp:8 nav_msgs/Path one_copy 'plan'
// subscribe src/node.cpp:9 nav_msgs/Path copied 'plan' TZC2010 its elements have strings, so the message is made from the shared bytes
// subscribe src/node.cpp:10 nav_msgs/Path copied 'plan' TZC2010 its elements have strings, so the message is made from the shared bytes
// publish src/node.cpp:15 nav_msgs/Path one_copy 'plan' TZC1018 its elements have strings, and publish() gathers them in shared memory
// publish src/node.cpp:19 nav_msgs/Path one_copy 'plan' TZC1018 its elements have strings, and publish() gathers them in shared memory
// publish src/node.cpp:21 nav_msgs/Path one_copy 'plan' TZC1018 its elements have strings, and publish() gathers them in shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh.advertise<nav_msgs::Path>("plan", 1);
// -    sub_ = nh.subscribe("plan", 1, &Planner::received, this);
// -    sub_own_ = nh.subscribe("plan", 1, &Planner::received_as_own, this);
// +    pub_ = tzc::advertise<nav_msgs::Path>(nh, "plan", 1);
// +    sub_ = tzc::subscribe(nh, "plan", 1, &Planner::received, this);
// +    sub_own_ = tzc::subscribe(nh, "plan", 1, &Planner::received_as_own, this);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
