// Two objects of one class have a mutex each.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

struct Guarded {
  std::mutex mutex;
};

class Map {
 public:
  Map() {
    map_.data.assign(1000, 7);
    often_ = nh_.createTimer(ros::Duration(0.1), &Map::send, this);
    asked_ = nh_.createTimer(ros::Duration(1), &Map::look_up, this);
  }
  void send(const ros::TimerEvent&) {
    std::lock_guard<std::mutex> lock(sending_.mutex);
    pub_.publish(map_);
  }
  void look_up(const ros::TimerEvent&) {
    std::lock_guard<std::mutex> lock(looking_.mutex);
    for (auto& cell : map_.data) count_ += cell != 0;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  Guarded sending_, looking_;
  ros::Timer often_, asked_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:20 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:29 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1, true);
