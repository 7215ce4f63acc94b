// Const is cast away from an array where nothing shows whose it is: kept, returned, captured, given to a function object or an override.
#include <functional>
#include <vector>

#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

struct Keeper {
  const std::vector<uint8_t>* bytes = nullptr;
};
Keeper keeper;
void trim() { const_cast<std::vector<uint8_t>*>(keeper.bytes)->resize(30000); }
void on_image(const sensor_msgs::ImageConstPtr& image) {
  keeper.bytes = &image->data;
  trim();
}

const std::vector<float>& ranges_of(const sensor_msgs::LaserScan& scan) { return scan.ranges; }
void on_scan(const sensor_msgs::LaserScanConstPtr& scan) {
  const_cast<std::vector<float>&>(ranges_of(*scan)).resize(30000);
}

std::function<void(const std::vector<int8_t>&)> cut = [](const std::vector<int8_t>& cells) {
  const_cast<std::vector<int8_t>&>(cells).resize(30000);
};
void on_map(const nav_msgs::OccupancyGridConstPtr& map) { cut(map->data); }

void run(ros::NodeHandle& nh) {
  ros::Subscriber images = nh.subscribe("image", 1, on_image);
  ros::Subscriber scans = nh.subscribe("scan", 1, on_scan);
  ros::Subscriber maps = nh.subscribe("map", 1, on_map);
}
//--- expected
// subscribe src/node.cpp:31 sensor_msgs/Image plain 'image' TZC2002 const is cast away from an array that may be one of this message's
// subscribe src/node.cpp:32 sensor_msgs/LaserScan plain 'scan' TZC2002 const is cast away from an array that may be one of this message's
// subscribe src/node.cpp:33 nav_msgs/OccupancyGrid plain 'map' TZC2002 const is cast away from an array that may be one of this message's
