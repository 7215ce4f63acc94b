// One place subscribes, each time that it is called: two of its subscriptions may be in the callback at the same time.
#include <string>
#include <vector>

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

class MapServer {
 public:
  MapServer() {
    map_.data.assign(1000000, 0);
    add("a");
    add("b");
  }
  void add(const std::string& name) {
    subs_.push_back(nh_.subscribe(name + "/goal", 1, &MapServer::on, this));
  }
  void on(const geometry_msgs::PoseStampedConstPtr&) {
    int count = 0;
    for (int8_t cell : map_.data) count += cell > 50;
    if (count < 9) pub_.publish(map_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
  nav_msgs::OccupancyGrid map_;
  std::vector<ros::Subscriber> subs_;
};
//--- expected
// subscribe src/node.cpp:17 geometry_msgs/PoseStamped not_needed
// publish src/node.cpp:22 nav_msgs/OccupancyGrid one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:27 nav_msgs/OccupancyGrid one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
// +  tzc::Publisher pub_ = tzc::advertise<nav_msgs::OccupancyGrid>(nh_, "map", 1, true);
