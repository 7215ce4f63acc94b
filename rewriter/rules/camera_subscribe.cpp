// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  sub = it.subscribeCamera("image", 1, &Viewer::on_image, this);
/// After:   sub = tzc::image_transport::subscribeCamera(it, "image", 1, &Viewer::on_image, this);
const MethodCall camera_subscribe{
    "camera-subscribe", MethodCall::Role::subscribe_transport,   "image_transport::ImageTransport",
    "subscribeCamera",  "tzc::image_transport::subscribeCamera", "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules
