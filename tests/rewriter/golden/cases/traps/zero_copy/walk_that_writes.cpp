// What writes has the message for itself, or the original would be wrong, too.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Map {
 public:
  Map() {
    map_.data.assign(1000, 7);
    often_ = nh_.createTimer(ros::Duration(0.1), &Map::send, this);
    asked_ = nh_.createTimer(ros::Duration(1), &Map::look_up, this);
  }
  void send(const ros::TimerEvent&) {
    pub_.publish(map_);
    map_.data.clear();
  }
  void look_up(const ros::TimerEvent&) {
    map_.data.resize(1000);
    for (auto& cell : map_.data) count_ += cell = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  ros::Timer often_, asked_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'map'
// advertise src/node.cpp:23 sensor_msgs/Image zero_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// -  sensor_msgs::Image map_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "map", 1, true);
// +  tzc::sensor_msgs::Image map_;
