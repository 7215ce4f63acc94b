// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pcl::fromROSMsg(message, cloud);
/// After:   tzc::pcl::fromROSMsg(message, cloud);
const LibraryCall pcl_from_ros_msg{"pcl-from-ros-msg",     "pcl::fromROSMsg", 0,
                                   "tzc::pcl::fromROSMsg", "tzc/pcl.h",       LibraryCall::Elements::left};

}  // namespace tzc::rewriter::rules
