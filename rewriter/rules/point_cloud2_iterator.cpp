// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
/// After:   tzc::sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
const ClassRename point_cloud2_iterator{"point-cloud2-iterator", ClassRename::Role::accessor,
                                        "sensor_msgs::PointCloud2Iterator",
                                        "tzc::sensor_msgs::PointCloud2Iterator", "tzc/sensor_msgs.h"};

}  // namespace tzc::rewriter::rules
