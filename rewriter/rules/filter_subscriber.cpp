// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  message_filters::Subscriber<sensor_msgs::Image> sub(nh, "image", 1);
/// After:   tzc::message_filters::Subscriber<sensor_msgs::Image> sub(nh, "image", 1);
const ClassRename filter_subscriber{"filter-subscriber", ClassRename::Role::filter,
                                    "message_filters::Subscriber", "tzc::message_filters::Subscriber",
                                    "tzc/message_filters.h"};

}  // namespace tzc::rewriter::rules
