// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Of an image publisher that stays what it is.
/// Before:  pub_.publish(image);
/// After:   tzc::image_transport::publish(pub_, image);
const MethodCall attached_image_publish{"attached-image-publish",        MethodCall::Role::publish,
                                        "image_transport::Publisher",    "publish",
                                        "tzc::image_transport::publish", "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules
