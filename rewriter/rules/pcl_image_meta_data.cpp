// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pcl_conversions::copyPCLImageMetaData(image, message);
/// After:   tzc::pcl_conversions::copyPCLImageMetaData(image, message);
const LibraryCall pcl_image_meta_data{"pcl-image-meta-data", "pcl_conversions::copyPCLImageMetaData", 1,
                                     "tzc::pcl_conversions::copyPCLImageMetaData", "tzc/pcl.h"};

}  // namespace tzc::rewriter::rules
