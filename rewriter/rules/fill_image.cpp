// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  sensor_msgs::fillImage(image, "rgb8", rows, cols, step, pixels);
/// After:   tzc::sensor_msgs::fillImage(image, "rgb8", rows, cols, step, pixels);
const LibraryCall fill_image{"fill-image", "sensor_msgs::fillImage", 0, "tzc::sensor_msgs::fillImage",
                             "tzc/sensor_msgs.h"};

}  // namespace tzc::rewriter::rules
