// Two threads share the array out between them: one reads its half by const access, one writes the other half.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <numeric>
#include <thread>

class Map {
 public:
  void step() {
    map_.data.assign(1000, 7);
    pub_.publish(map_);
    const sensor_msgs::Image& same = map_;
    std::thread reader([&] { count_ = std::accumulate(same.data.begin() + 500, same.data.end(), 0); });
    for (int i = 0; i < 500; ++i) map_.data[i] = 1;
    reader.join();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1);
  sensor_msgs::Image map_;
  int count_ = 0;
};

void run() { Map().step(); }
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'map' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// advertise src/node.cpp:22 sensor_msgs/Image one_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("map", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "map", 1);
