// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  sensor_msgs::PointCloud2Modifier modifier(cloud);
/// After:   tzc::sensor_msgs::PointCloud2Modifier modifier(cloud);
const ClassRename point_cloud2_modifier{"point-cloud2-modifier", ClassRename::Role::accessor,
                                        "sensor_msgs::PointCloud2Modifier",
                                        "tzc::sensor_msgs::PointCloud2Modifier", "tzc/sensor_msgs.h"};

}  // namespace tzc::rewriter::rules
