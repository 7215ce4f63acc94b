// Two timers look at one element, a third one publishes: while the first has the element's place, the second may move the elements twice.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Map {
 public:
  Map() {
    map_.data.assign(1000, 7);
    often_ = nh_.createTimer(ros::Duration(0.1), &Map::send, this);
    first_ = nh_.createTimer(ros::Duration(1), &Map::look, this);
    second_ = nh_.createTimer(ros::Duration(1), &Map::peek, this);
  }
  void send(const ros::TimerEvent&) { pub_.publish(map_); }
  void look(const ros::TimerEvent&) { count_ += map_.data[7]; }
  void peek(const ros::TimerEvent&) { sum_ += map_.data.at(8); }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  ros::Timer often_, first_, second_;
  int count_ = 0, sum_ = 0;
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1, true);
