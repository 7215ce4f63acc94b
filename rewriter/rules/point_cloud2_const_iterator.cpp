// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x");
/// After:   tzc::sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x");
const ClassRename point_cloud2_const_iterator{
    "point-cloud2-const-iterator", ClassRename::Role::accessor, "sensor_msgs::PointCloud2ConstIterator",
    "tzc::sensor_msgs::PointCloud2ConstIterator", "tzc/sensor_msgs.h"};

}  // namespace tzc::rewriter::rules
