// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pub = it.advertise("image", 1);
/// After:   pub = tzc::image_transport::advertise(it, "image", 1);
const MethodCall image_advertise{
    "image-advertise", MethodCall::Role::advertise_transport, "image_transport::ImageTransport",
    "advertise",       "tzc::image_transport::advertise",     "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules
