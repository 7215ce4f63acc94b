// A vector that is made on the spot: the array gets what it would have held, where it lies.
#include <set>
#include <vector>

#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

class Node {
 public:
  Node() {
    scan_pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10);
    grid_pub_ = nh_.advertise<nav_msgs::OccupancyGrid>("grid", 10);
  }
  void publish(const std::set<int8_t>& given, int n) {
    sensor_msgs::LaserScan scan;
    scan.ranges = std::vector<float>(n * 2);
    scan.intensities = std::vector<float>(scan.ranges.size(), 1);
    scan.ranges[0] = 3;
    scan_pub_.publish(scan);
    std::set<int8_t> all(given);
    boost::shared_ptr<nav_msgs::OccupancyGrid> grid = boost::make_shared<nav_msgs::OccupancyGrid>();
    grid->data = std::vector<int8_t>(all.begin(), all.end());
    grid_pub_.publish(grid);
    nav_msgs::OccupancyGrid others;
    if (n > 3) others.data = std::vector<int8_t>(kept_.rbegin(), kept_.rend());
    grid_pub_.publish(others);
  }
  void publish_buffer(int n) {
    int8_t buffer[100] = {1, 2};
    nav_msgs::OccupancyGrid read;
    read.data = std::vector<int8_t>(buffer, buffer + n);
    grid_pub_.publish(read);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher scan_pub_, grid_pub_;
  std::vector<int8_t> kept_;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/LaserScan zero_copy 'scan'
// advertise src/node.cpp:13 nav_msgs/OccupancyGrid zero_copy 'grid'
// publish src/node.cpp:20 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:24 nav_msgs/OccupancyGrid zero_copy 'grid'
// publish src/node.cpp:27 nav_msgs/OccupancyGrid zero_copy 'grid'
// publish src/node.cpp:33 nav_msgs/OccupancyGrid zero_copy 'grid'
//
// +++ src/node.cpp
// +#include <tzc/nav_msgs/OccupancyGrid.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -    scan_pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10);
// -    grid_pub_ = nh_.advertise<nav_msgs::OccupancyGrid>("grid", 10);
// +    scan_pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 10);
// +    grid_pub_ = tzc::advertise<tzc::nav_msgs::OccupancyGrid>(nh_, "grid", 10);
// -    sensor_msgs::LaserScan scan;
// -    scan.ranges = std::vector<float>(n * 2);
// -    scan.intensities = std::vector<float>(scan.ranges.size(), 1);
// +    tzc::sensor_msgs::LaserScan scan;
// +    scan_pub_.allocate(scan);
// +    scan.ranges.assign(n * 2, 0);
// +    scan.intensities.assign(scan.ranges.size(), 1);
// -    boost::shared_ptr<nav_msgs::OccupancyGrid> grid = boost::make_shared<nav_msgs::OccupancyGrid>();
// -    grid->data = std::vector<int8_t>(all.begin(), all.end());
// +    boost::shared_ptr<tzc::nav_msgs::OccupancyGrid> grid = boost::make_shared<tzc::nav_msgs::OccupancyGrid>();
// +    grid_pub_.allocate(*grid);
// +    grid->data.assign(all.begin(), all.end());
// -    nav_msgs::OccupancyGrid others;
// -    if (n > 3) others.data = std::vector<int8_t>(kept_.rbegin(), kept_.rend());
// +    tzc::nav_msgs::OccupancyGrid others;
// +    grid_pub_.allocate(others);
// +    if (n > 3) others.data.assign(kept_.rbegin(), kept_.rend());
// -    nav_msgs::OccupancyGrid read;
// -    read.data = std::vector<int8_t>(buffer, buffer + n);
// +    tzc::nav_msgs::OccupancyGrid read;
// +    grid_pub_.allocate(read);
// +    read.data.assign(buffer, buffer + n);
// -  ros::Publisher scan_pub_, grid_pub_;
// +  tzc::Publisher scan_pub_, grid_pub_;
