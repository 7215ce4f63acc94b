// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  cv_image.toImageMsg(message);
/// After:   tzc::cv_bridge::to_image_msg(cv_image, message);
const MethodCall cv_image_into_message{"cv-image-into-message",
                                       MethodCall::Role::fills_message,
                                       "cv_bridge::CvImage",
                                       "toImageMsg",
                                       "tzc::cv_bridge::to_image_msg",
                                       "tzc/cv_bridge.h",
                                       1};

}  // namespace tzc::rewriter::rules
