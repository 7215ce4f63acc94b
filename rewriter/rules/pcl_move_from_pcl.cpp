// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pcl_conversions::moveFromPCL(cloud, message);
/// After:   tzc::pcl_conversions::moveFromPCL(cloud, message);
const LibraryCall pcl_move_from_pcl{
    "pcl-move-from-pcl", "pcl_conversions::moveFromPCL",  1, "tzc::pcl_conversions::moveFromPCL",
    "tzc/pcl.h",         LibraryCall::Elements::of_vector};

}  // namespace tzc::rewriter::rules
