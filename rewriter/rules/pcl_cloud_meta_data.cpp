// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pcl_conversions::copyPCLPointCloud2MetaData(cloud, message);
/// After:   tzc::pcl_conversions::copyPCLPointCloud2MetaData(cloud, message);
const LibraryCall pcl_cloud_meta_data{"pcl-cloud-meta-data", "pcl_conversions::copyPCLPointCloud2MetaData", 1,
                                          "tzc::pcl_conversions::copyPCLPointCloud2MetaData", "tzc/pcl.h"};

}  // namespace tzc::rewriter::rules
