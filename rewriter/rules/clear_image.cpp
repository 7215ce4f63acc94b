// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  sensor_msgs::clearImage(image);
/// After:   tzc::sensor_msgs::clearImage(image);
const LibraryCall clear_image{"clear-image", "sensor_msgs::clearImage", 0, "tzc::sensor_msgs::clearImage",
                              "tzc/sensor_msgs.h"};

}  // namespace tzc::rewriter::rules
