// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pcl_conversions::fromPCL(cloud, message);
/// After:   tzc::pcl_conversions::fromPCL(cloud, message);
const LibraryCall pcl_from_pcl{"pcl-from-pcl", "pcl_conversions::fromPCL", 1, "tzc::pcl_conversions::fromPCL",
                               "tzc/pcl.h"};

}  // namespace tzc::rewriter::rules
