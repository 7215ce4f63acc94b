// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  projector.projectLaser(scan, cloud);
/// After:   tzc::laser_geometry::projectLaser(projector, scan, cloud);
const MethodCall laser_projection{"laser-projection",
                                  MethodCall::Role::fills_message,
                                  "laser_geometry::LaserProjection",
                                  "projectLaser",
                                  "tzc::laser_geometry::projectLaser",
                                  "tzc/laser_geometry.h",
                                  -1,
                                  1,
                                  "sensor_msgs/PointCloud2"};

}  // namespace tzc::rewriter::rules
