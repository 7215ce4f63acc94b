// What a service answers is copied from what is published: the answer stays a stock message.
#include <nav_msgs/GetMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

class Mapper {
 public:
  Mapper() : pub_(nh_.advertise<nav_msgs::OccupancyGrid>("map", 1)) {}
  bool get(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& res) {
    res.map = map_;
    return true;
  }
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
// advertise src/node.cpp:8 nav_msgs/OccupancyGrid zero_copy 'map'
// publish src/node.cpp:20 nav_msgs/OccupancyGrid zero_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/nav_msgs/OccupancyGrid.h>
// +#include <tzc/ros.h>
// -  Mapper() : pub_(nh_.advertise<nav_msgs::OccupancyGrid>("map", 1)) {}
// +  Mapper() : pub_(tzc::advertise<tzc::nav_msgs::OccupancyGrid>(nh_, "map", 1)) {}
// -    res.map = map_;
// +    res.map = nav_msgs::OccupancyGrid(map_);
// -  ros::Publisher pub_;
// -  nav_msgs::OccupancyGrid map_;
// +  tzc::Publisher pub_;
// +  tzc::nav_msgs::OccupancyGrid map_;
