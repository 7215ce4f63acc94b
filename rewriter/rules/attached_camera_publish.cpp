// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pub_.publish(image, info);  // of a publisher that stays what it is
/// After:   tzc::image_transport::publish(pub_, image, info);
const MethodCall attached_camera_publish{"attached-camera-publish",          MethodCall::Role::publish,
                                         "image_transport::CameraPublisher", "publish",
                                         "tzc::image_transport::publish",    "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules
