// A lock that both have keeps the reader and the publish apart, whatever leads to the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

class Map {
 public:
  Map() {
    map_ = boost::make_shared<sensor_msgs::Image>();
    often_ = nh_.createTimer(ros::Duration(0.1), &Map::send, this);
    asked_ = nh_.createTimer(ros::Duration(1), &Map::look_up, this);
  }
  void send(const ros::TimerEvent&) {
    std::lock_guard<std::mutex> lock(mutex_);
    map_->data.resize(1000);
    pub_.publish(map_);
  }
  void look_up(const ros::TimerEvent&) {
    std::lock_guard<std::mutex> lock(mutex_);
    const sensor_msgs::Image& map = *map_;
    for (auto& cell : map.data) count_ += cell != 0;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::ImagePtr map_;
  std::mutex mutex_;
  ros::Timer often_, asked_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'map'
// advertise src/node.cpp:27 sensor_msgs/Image zero_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    map_ = boost::make_shared<sensor_msgs::Image>();
// +    map_ = boost::make_shared<tzc::sensor_msgs::Image>();
// +    pub_.allocate(*map_);
// -    const sensor_msgs::Image& map = *map_;
// +    const tzc::sensor_msgs::Image& map = *map_;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// -  sensor_msgs::ImagePtr map_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "map", 1, true);
// +  tzc::sensor_msgs::ImagePtr map_;
