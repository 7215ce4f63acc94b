// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pub = transport.advertise("image", 10);  // of a publisher that stays what it is
/// After:   pub = tzc::image_transport::attached(transport.advertise("image", 10));
const AttachedAdvertise attached_image_advertise{"attached-image-advertise", "image_transport::Publisher",
                                                 false, "tzc::image_transport::attached",
                                                 "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules
