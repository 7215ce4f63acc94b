// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pub.publish(cv_image.toImageMsg());
/// After:   pub.publish(tzc::cv_bridge::to_image_msg(cv_image, pub));
const MethodCall cv_image_to_message{"cv-image-to-message",
                                     MethodCall::Role::builds_message,
                                     "cv_bridge::CvImage",
                                     "toImageMsg",
                                     "tzc::cv_bridge::to_image_msg",
                                     "tzc/cv_bridge.h",
                                     0};

}  // namespace tzc::rewriter::rules
