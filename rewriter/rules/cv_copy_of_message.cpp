// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  cv_bridge::toCvCopy(message, "bgr8");
/// After:   tzc::cv_bridge::toCvCopy(message, "bgr8");
const LibraryCall cv_copy_of_message{
    "cv-copy-of-message",       "cv_bridge::toCvCopy", 0,
    "tzc::cv_bridge::toCvCopy", "tzc/cv_bridge.h",     LibraryCall::Elements::left};

}  // namespace tzc::rewriter::rules
