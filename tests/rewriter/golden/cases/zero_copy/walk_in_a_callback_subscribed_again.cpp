// A function that may be called several times subscribes: each time it ends what it subscribed to before.
#include <string>

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

class MapServer {
 public:
  MapServer() { map_.data.assign(1000000, 0); }
  void listen(const std::string& name) {
    sub_ = nh_.subscribe(name + "/goal", 1, &MapServer::on, this);
  }
  void on(const geometry_msgs::PoseStampedConstPtr&) {
    map_.data.assign(1000000, 0);
    int count = 0;
    for (int8_t cell : map_.data) count += cell > 50;
    if (count < 9) pub_.publish(map_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
  nav_msgs::OccupancyGrid map_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:12 geometry_msgs/PoseStamped not_needed
// publish src/node.cpp:18 nav_msgs/OccupancyGrid zero_copy 'map'
// advertise src/node.cpp:23 nav_msgs/OccupancyGrid zero_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/nav_msgs/OccupancyGrid.h>
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
// -  nav_msgs::OccupancyGrid map_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::nav_msgs::OccupancyGrid>(nh_, "map", 1, true);
// +  tzc::nav_msgs::OccupancyGrid map_;
