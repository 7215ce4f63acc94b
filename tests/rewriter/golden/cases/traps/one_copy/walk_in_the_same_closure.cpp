// Closures that are called where they are made, or by an algorithm, or by one timer: nobody else is there meanwhile, and the port is safe.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

class Map {
 public:
  Map() {
    map_.data.assign(1000, 7);
    often_ = nh_.createTimer(ros::Duration(0.1), [this](const ros::TimerEvent&) {
      const auto sum = [&] {
        int count = 0;
        for (uint8_t cell : map_.data) count += cell;
        return count;
      };
      count_ += std::count_if(map_.data.begin(), map_.data.end(), [&](uint8_t cell) { return cell > count_; });
      [&] {
        for (uint8_t cell : map_.data) count_ += cell;
      }();
      if (sum() > 3 && look_up() > 3) pub_.publish(map_);
    });
  }
  int look_up() { return *std::max_element(map_.data.begin(), map_.data.end()); }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  ros::Timer often_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'map' TZC1022 line 17 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:28 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// -  sensor_msgs::Image map_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "map", 1, true);
// +  tzc::sensor_msgs::Image map_;
