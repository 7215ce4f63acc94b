// A pointer that lasts leads another thread to the message, as a message that lasts itself would.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Map {
 public:
  Map() : map_(boost::make_shared<sensor_msgs::Image>()) {
    often_ = nh_.createTimer(ros::Duration(0.1), &Map::send, this);
    asked_ = nh_.createTimer(ros::Duration(1), &Map::look_up, this);
  }
  void send(const ros::TimerEvent&) {
    map_->data.resize(1000);
    pub_.publish(map_);
    publish_again();
  }
  void look_up(const ros::TimerEvent&) {
    for (auto& cell : map_->data) count_ += cell != 0;
  }

 private:
  void publish_again() { pub_.publish(map_); }
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::ImagePtr map_;
  ros::Timer often_, asked_;
  int count_ = 0;
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:23 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1, true);
