// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pub = it.advertiseCamera("image", 1);
/// After:   pub = tzc::image_transport::advertiseCamera(it, "image", 1);
const MethodCall camera_advertise{
    "camera-advertise", MethodCall::Role::advertise_transport,   "image_transport::ImageTransport",
    "advertiseCamera",  "tzc::image_transport::advertiseCamera", "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules
