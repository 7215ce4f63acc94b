// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  offset = addPointField(cloud, "x", 1, sensor_msgs::PointField::FLOAT32, offset);
/// After:   offset = tzc::sensor_msgs::addPointField(cloud, "x", 1, sensor_msgs::PointField::FLOAT32, offset);
const LibraryCall add_point_field{
    "add-point-field",          "addPointField", 0, "tzc::sensor_msgs::addPointField", "tzc/sensor_msgs.h",
    LibraryCall::Elements::left};

}  // namespace tzc::rewriter::rules
