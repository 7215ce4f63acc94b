// One mutex, locked and unlocked by hand.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

class Map {
 public:
  Map() {
    map_.data.assign(1000, 7);
    often_ = nh_.createTimer(ros::Duration(0.1), &Map::send, this);
    asked_ = nh_.createTimer(ros::Duration(1), &Map::look_up, this);
  }
  void send(const ros::TimerEvent&) {
    mutex_.lock();
    pub_.publish(map_);
    mutex_.unlock();
  }
  void look_up(const ros::TimerEvent&) {
    mutex_.lock();
    for (auto& cell : map_.data) count_ += cell != 0;
    mutex_.unlock();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  std::mutex mutex_;
  ros::Timer often_, asked_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'map' TZC1022 line 21 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:27 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// -  sensor_msgs::Image map_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "map", 1, true);
// +  tzc::sensor_msgs::Image map_;
