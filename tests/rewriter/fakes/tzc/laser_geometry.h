// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <laser_geometry/laser_geometry.h>
#include <tzc/sensor_msgs/PointCloud2.h>
namespace tzc {
namespace laser_geometry {
inline void projectLaser(::laser_geometry::LaserProjection&, const ::sensor_msgs::LaserScan&,
                         sensor_msgs::PointCloud2&, double = -1.0,
                         int = ::laser_geometry::channel_option::Default) {}
}  // namespace laser_geometry
}  // namespace tzc
