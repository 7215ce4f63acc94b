// One timer publishes the map, another one goes through it. Neither writes, so neither locks; but elements that were published move at
// the next access that is not const, and an end would be another memory's than the begin.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Map {
 public:
  Map() {
    map_.data.assign(1000, 7);
    often_ = nh_.createTimer(ros::Duration(0.1), &Map::send, this);
    asked_ = nh_.createTimer(ros::Duration(1), &Map::look_up, this);
  }
  void send(const ros::TimerEvent&) { pub_.publish(map_); }
  void look_up(const ros::TimerEvent&) {
    for (auto cell = map_.data.begin(); cell != map_.data.end(); ++cell) count_ += *cell != 0;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  ros::Timer often_, asked_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1, true);
