// The publisher's function locks, the closure that a thread runs does not.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>
#include <thread>

class Map {
 public:
  void step() {
    map_.data.assign(1000, 7);
    std::thread reader([this] {
      for (uint8_t cell : map_.data) count_ += cell;
    });
    {
      std::lock_guard<std::mutex> lock(mutex_);
      pub_.publish(map_);
    }
    reader.join();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1);
  sensor_msgs::Image map_;
  std::mutex mutex_;
  int count_ = 0;
};

void run() { Map().step(); }
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:24 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1);
