// Callbacks that are written in the constructor run when it has ended, on any thread of a spinner.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Map {
 public:
  Map() {
    map_.data.assign(1000, 7);
    often_ = nh_.createTimer(ros::Duration(0.1), [this](const ros::TimerEvent&) { pub_.publish(map_); });
    asked_ = nh_.createTimer(ros::Duration(1), [this](const ros::TimerEvent&) {
      for (uint8_t cell : map_.data) count_ += cell;
    });
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  ros::Timer often_, asked_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:9 sensor_msgs/Image one_copy 'map' TZC1003 '__begin2' points into its data and is used after the message may have been published
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1, true);
