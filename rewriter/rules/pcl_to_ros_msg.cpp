// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pcl::toROSMsg(cloud, message);
/// After:   tzc::pcl::toROSMsg(cloud, message);
const LibraryCall pcl_to_ros_msg{"pcl-to-ros-msg", "pcl::toROSMsg", 1, "tzc::pcl::toROSMsg", "tzc/pcl.h"};

}  // namespace tzc::rewriter::rules
