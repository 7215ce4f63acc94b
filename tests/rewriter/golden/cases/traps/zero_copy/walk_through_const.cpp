// Const access moves no element, whoever publishes meanwhile.
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
  void look_up(const ros::TimerEvent&) { count_ += occupied(); }
  int occupied() const {
    int count = 0;
    for (auto cell = map_.data.begin(); cell != map_.data.end(); ++cell) count += *cell != 0;
    return count;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  ros::Timer often_, asked_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'map'
// advertise src/node.cpp:22 sensor_msgs/Image zero_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// -  sensor_msgs::Image map_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "map", 1, true);
// +  tzc::sensor_msgs::Image map_;
