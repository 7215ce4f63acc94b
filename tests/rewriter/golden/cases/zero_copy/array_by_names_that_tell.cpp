// Each name of the array says that it is one; what becomes void* are elements.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

template <class It>
float sum_of(const std::pair<It, It>& range) {
  float sum = 0;
  for (It it = range.first; it != range.second; ++it) sum += *it;
  return sum;
}

template <class Values>
void fill(Values&& values, float value) {
  for (auto& one : static_cast<Values&&>(values)) one = value;
}

void run(ros::NodeHandle& nh, const std::vector<float>& from, std::FILE* file) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
  sensor_msgs::LaserScan scan;
  scan.ranges.resize(from.size());
  std::memcpy(scan.ranges.data(), from.data(), from.size() * sizeof(float));
  std::memset(&scan.ranges[0], 0, 4);
  std::fwrite(&scan.ranges[0], sizeof(float), scan.ranges.size(), file);
  fill(scan.ranges, 2.f);
  auto* named = from.empty() ? nullptr : &scan.ranges;
  if (named) named->push_back(1);
  if (named != nullptr) scan.angle_min = named->size();
  (void)scan.intensities;
  const std::vector<float>& read(scan.ranges);
  scan.angle_max = read.empty() ? 0 : read.front();
  scan.angle_max = sum_of(std::make_pair(scan.ranges.begin(), scan.ranges.end()));
  pub.publish(scan);
}
//--- expected
// advertise src/node.cpp:24 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:38 sensor_msgs/LaserScan zero_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
// -  sensor_msgs::LaserScan scan;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "scan", 10);
// +  tzc::sensor_msgs::LaserScan scan;
// +  pub.allocate(scan);
// -  const std::vector<float>& read(scan.ranges);
// +  const auto& read(scan.ranges);
