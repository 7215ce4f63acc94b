// One goes through the elements by const access, and another one, that moves them, does so at the same time. Neither publishes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <string>

class Map {
 public:
  Map() {
    map_.data.assign(1000, 7);
    other_ = nh_.createTimer(ros::Duration(2), [this](const ros::TimerEvent&) {
      count_ += map_.data[7];
    });
    often_ = nh_.createTimer(ros::Duration(0.1), &Map::send, this);
    asked_ = nh_.createTimer(ros::Duration(1), &Map::look_up, this);
  }
  void send(const ros::TimerEvent&) {
    pub_.publish(map_);
  }
  void look_up(const ros::TimerEvent&) {
    const sensor_msgs::Image& same = map_;
    for (uint8_t cell : same.data) count_ += cell;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  ros::Timer other_;
  ros::Timer often_, asked_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:27 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1, true);
