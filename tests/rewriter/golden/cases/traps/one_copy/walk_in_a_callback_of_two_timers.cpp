// One function, which two timers call: each of them may be in it at the same time.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Map {
 public:
  Map() {
    map_.data.assign(1000, 7);
    often_ = nh_.createTimer(ros::Duration(0.1), &Map::tick, this);
    seldom_ = nh_.createTimer(ros::Duration(1), &Map::tick, this);
  }
  void tick(const ros::TimerEvent&) {
    int count = 0;
    for (uint8_t cell : map_.data) count += cell;
    if (count > 3) pub_.publish(map_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  ros::Timer often_, seldom_;
};
//--- expected
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1, true);
