// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  image_transport::SubscriberFilter sub(it, "image", 1);
/// After:   tzc::image_transport::SubscriberFilter sub(it, "image", 1);
const ClassRename subscriber_filter{"subscriber-filter", ClassRename::Role::filter,
                                    "image_transport::SubscriberFilter",
                                    "tzc::image_transport::SubscriberFilter", "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules
