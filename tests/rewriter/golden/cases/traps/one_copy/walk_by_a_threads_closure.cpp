// A thread calls the function that goes through the elements, while the function that made the thread publishes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <thread>

class Map {
 public:
  void step() {
    map_.data.assign(1000, 7);
    std::thread reader([this] { count_ = look_up(); });
    pub_.publish(map_);
    reader.join();
  }
  int look_up() {
    int count = 0;
    for (auto cell = map_.data.begin(); cell != map_.data.end(); ++cell) count += *cell;
    return count;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1);
  sensor_msgs::Image map_;
  int count_ = 0;
};

void run() { Map().step(); }
//--- expected
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:23 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1);
