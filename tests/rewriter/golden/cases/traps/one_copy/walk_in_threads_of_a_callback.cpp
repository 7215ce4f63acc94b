// Each request makes a thread that goes through the elements and publishes; the one of an earlier request may be at it still.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <thread>

class Map {
 public:
  Map() {
    map_.data.assign(1000, 7);
    asked_ = nh_.createTimer(ros::Duration(1), &Map::request, this);
  }
  void request(const ros::TimerEvent&) { std::thread(&Map::work, this).detach(); }
  void work() {
    int count = 0;
    for (uint8_t cell : map_.data) count += cell;
    if (count > 3) pub_.publish(map_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  ros::Timer asked_;
};
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:22 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1, true);
