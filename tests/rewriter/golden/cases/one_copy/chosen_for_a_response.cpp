// What is copied into a service is one of two messages: one conversion cannot be right for both.
#include <nav_msgs/GetMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

class Mapper {
 public:
  Mapper() : pub_(nh_.advertise<nav_msgs::OccupancyGrid>("map", 1)) {}
  bool get(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& res) {
    res.map = first ? map_ : other_;
    return true;
  }
  bool first = true;
  nav_msgs::OccupancyGrid other_;
  bool getNewest(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& res) {
    if (!maps_.empty()) res.map = maps_[0];
    res.map = (*newest_);
    return true;
  }
  void tick() {
    map_.data.assign(1000 * 1000, -1);
    pub_.publish(map_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  nav_msgs::OccupancyGrid map_;
  std::vector<nav_msgs::OccupancyGrid> maps_;
  nav_msgs::OccupancyGridPtr newest_;
};
//--- expected
// advertise src/node.cpp:8 nav_msgs/OccupancyGrid one_copy 'map'
// publish src/node.cpp:22 nav_msgs/OccupancyGrid one_copy 'map' TZC1002 it is part of a service
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Mapper() : pub_(nh_.advertise<nav_msgs::OccupancyGrid>("map", 1)) {}
// +  Mapper() : pub_(tzc::advertise<nav_msgs::OccupancyGrid>(nh_, "map", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
