// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  sub = it.subscribe("image", 1, &Viewer::on_image, this);
/// After:   sub = tzc::image_transport::subscribe(it, "image", 1, &Viewer::on_image, this);
const MethodCall image_subscribe{
    "image-subscribe", MethodCall::Role::subscribe_transport, "image_transport::ImageTransport",
    "subscribe",       "tzc::image_transport::subscribe",     "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules
