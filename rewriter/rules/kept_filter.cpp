// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Of a filter that stays what it is, as a member that an exported header shows.
/// Before:  cloud_.subscribe(nh, "cloud", 1);
/// After:   tzc::message_filters::subscribe(cloud_, nh, "cloud", 1);
const MethodCall kept_filter{"kept-filter", MethodCall::Role::subscribe,       "message_filters::Subscriber",
                             "subscribe",   "tzc::message_filters::subscribe", "tzc/message_filters.h"};

}  // namespace tzc::rewriter::rules
