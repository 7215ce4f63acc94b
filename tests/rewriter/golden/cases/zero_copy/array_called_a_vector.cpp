// Names and copies of the array whose type is written as std::vector: the names follow, the copies stay vectors.
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

class Scanner {
 public:
  explicit Scanner(ros::NodeHandle& nh)
      : pub_(nh.advertise<sensor_msgs::LaserScan>("scan", 10)), grid_(nh.advertise<nav_msgs::OccupancyGrid>("grid", 10)) {}

  std::vector<float> publish(int n) {
    sensor_msgs::LaserScan scan;
    std::vector<float>& ranges = scan.ranges;
    ranges.resize(n);
    for (int i = 0; i < n; ++i) ranges[i] = 0.5f * i;
    const std::vector<float>& seen = scan.ranges;
    scan.intensities.push_back(seen.empty() ? 0 : seen.front());
    const std::vector<float>* const same = &scan.ranges;
    if (same->size() > 100) return {};
    const std::vector<float> before = scan.ranges, intensities = (scan.intensities);
    last_ = scan.ranges;
    if (n > 3) this->last_ = scan.intensities;
    pub_.publish(scan);
    scan.angle_max = before.size() + intensities.size();
    return scan.ranges;
  }

  void publish_grid(int n) {
    nav_msgs::OccupancyGrid grid;
    nav_msgs::OccupancyGrid::_data_type& cells = grid.data;
    cells.assign(n, -1);
    nav_msgs::OccupancyGrid::_data_type kept = grid.data;
    grid.width = kept.size();
    grid_.publish(grid);
  }

 private:
  ros::Publisher pub_, grid_;
  std::vector<float> last_;
};

void run(ros::NodeHandle& nh) {
  Scanner(nh).publish(7);
  Scanner(nh).publish_grid(7);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/LaserScan zero_copy 'scan'
// advertise src/node.cpp:9 nav_msgs/OccupancyGrid zero_copy 'grid'
// publish src/node.cpp:23 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:34 nav_msgs/OccupancyGrid zero_copy 'grid'
//
// +++ src/node.cpp
// +#include <tzc/nav_msgs/OccupancyGrid.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -      : pub_(nh.advertise<sensor_msgs::LaserScan>("scan", 10)), grid_(nh.advertise<nav_msgs::OccupancyGrid>("grid", 10)) {}
// +      : pub_(tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "scan", 10)), grid_(tzc::advertise<tzc::nav_msgs::OccupancyGrid>(nh, "grid", 10)) {}
// -    sensor_msgs::LaserScan scan;
// -    std::vector<float>& ranges = scan.ranges;
// +    tzc::sensor_msgs::LaserScan scan;
// +    pub_.allocate(scan);
// +    auto& ranges = scan.ranges;
// -    const std::vector<float>& seen = scan.ranges;
// +    const auto& seen = scan.ranges;
// -    const std::vector<float>* const same = &scan.ranges;
// +    const auto* const same = &scan.ranges;
// -    const std::vector<float> before = scan.ranges, intensities = (scan.intensities);
// -    last_ = scan.ranges;
// -    if (n > 3) this->last_ = scan.intensities;
// +    const std::vector<float> before = std::vector<float>(scan.ranges), intensities = (std::vector<float>(scan.intensities));
// +    scan.ranges.copy_to(last_);
// +    if (n > 3) scan.intensities.copy_to(this->last_);
// -    return scan.ranges;
// +    return std::vector<float>(scan.ranges);
// -    nav_msgs::OccupancyGrid grid;
// -    nav_msgs::OccupancyGrid::_data_type& cells = grid.data;
// +    tzc::nav_msgs::OccupancyGrid grid;
// +    grid_.allocate(grid);
// +    auto& cells = grid.data;
// -    nav_msgs::OccupancyGrid::_data_type kept = grid.data;
// +    nav_msgs::OccupancyGrid::_data_type kept = nav_msgs::OccupancyGrid::_data_type(grid.data);
// -  ros::Publisher pub_, grid_;
// +  tzc::Publisher pub_, grid_;
