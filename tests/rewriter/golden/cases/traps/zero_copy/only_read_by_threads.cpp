// A message that is filled once, and published and read by several threads at once: reading needs no lock, so the port may not write.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <thread>

class Map {
 public:
  Map() {
    map_.data.resize(1000);
    fast_ = nh_.createTimer(ros::Duration(0.1), &Map::send, this);
    slow_ = nh_.createTimer(ros::Duration(1), &Map::send, this);
  }
  void send(const ros::TimerEvent&) { pub_.publish(map_); }
  int occupied() const {
    int count = 0;
    for (auto cell : map_.data) count += cell != 0;
    return count;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
  sensor_msgs::Image map_;
  ros::Timer fast_, slow_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Map map;
  std::thread reader([&map] {
    while (ros::ok()) map.occupied();
  });
  ros::spin();
  reader.join();
}
//--- expected
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'map'
// advertise src/node.cpp:23 sensor_msgs/Image zero_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, true);
// -  sensor_msgs::Image map_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "map", 1, true);
// +  tzc::sensor_msgs::Image map_;
