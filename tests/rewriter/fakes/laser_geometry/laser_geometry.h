// SPDX-License-Identifier: BSD-3-Clause
// The declarations of laser_geometry that cases use.
#pragma once
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/PointCloud2.h>

namespace laser_geometry {
namespace channel_option {
enum ChannelOption { None = 0, Intensity = 1, Index = 2, Distance = 4, Default = Intensity | Index };
}  // namespace channel_option

class LaserProjection {
 public:
  void projectLaser(const sensor_msgs::LaserScan& scan, sensor_msgs::PointCloud& cloud,
                    double range_cutoff = -1.0, int channel_options = channel_option::Default);
  void projectLaser(const sensor_msgs::LaserScan& scan, sensor_msgs::PointCloud2& cloud,
                    double range_cutoff = -1.0, int channel_options = channel_option::Default);
};
}  // namespace laser_geometry
