// The package has a function that waits and comes back without the lock.
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
    std::unique_lock<std::mutex> lock(mutex_);
    wait_for_data(lock);
    pub_.publish(map_);
  }
  void look_up(const ros::TimerEvent&) {
    std::lock_guard<std::mutex> lock(mutex_);
    for (auto& cell : map_.data) count_ += cell != 0;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  std::mutex mutex_;
  void wait_for_data(std::unique_lock<std::mutex>& lock) { lock.unlock(); }
  ros::Timer often_, asked_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:26 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1, true);
