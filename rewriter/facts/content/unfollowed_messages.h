// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

#include <string>

#include "facts/syntax/message_parts.h"
#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// The type of the message that an expression denotes or leads to, "sensor_msgs/Image", where it may be any of the package's:
/// it has no name here, and is neither new nor of another package. Empty: it is followed, or is no message.
std::string unfollowed_type(const Unit& unit, const MessageParts& parts, const clang::Expr* expr);

}  // namespace tzc::rewriter
