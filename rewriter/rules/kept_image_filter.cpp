// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Of an image filter that stays what it is.
/// Before:  image_.subscribe(*it_, "image", 1);
/// After:   tzc::message_filters::subscribe(image_, *it_, "image", 1);
const MethodCall kept_image_filter{
    "kept-image-filter", MethodCall::Role::subscribe_transport, "image_transport::SubscriberFilter",
    "subscribe",         "tzc::message_filters::subscribe",     "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules
