// The constructor makes one thread, and nobody else publishes or reads: safe, although each look after a publish copies.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <thread>

class Map {
 public:
  Map() {
    map_.data.assign(1000, 7);
    worker_ = std::thread(&Map::work, this);
  }
  void work() {
    int count = 0;
    for (uint8_t cell : map_.data) count += cell;
    if (count > 3) pub_.publish(map_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  std::thread worker_;
};
//--- expected
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'map' TZC1022 line 15 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:21 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// -  sensor_msgs::Image map_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "map", 1, true);
// +  tzc::sensor_msgs::Image map_;
