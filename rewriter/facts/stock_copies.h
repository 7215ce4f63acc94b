// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <vector>

#include "facts/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// The edits with which a function that takes `const M&` gets a stock copy of a local message, so that the message may be ported
/// while the function, which others give stock messages, stays:
///
///   sensor_msgs::Image image;         tzc::sensor_msgs::Image image;
///                                     sensor_msgs::Image image_stock;
///   fill(size, image);                fill(size, image);
///   check(image);                     check(image_stock = tzc::message::to_stock(image));
///
/// Empty unless nobody can tell the copy from the message. It has the message's scope, so that what is kept of it lives as long, and is
/// made once. The message starts empty, and nothing but its name leads to it: each mention is an argument of a call, or reads a
/// number. What writes to it is a function that can keep where it is only in a global: no member function, and it cannot write to what
/// else it is given. Who writes to it is called before, and no loop leads back, so it never changes after the copy was made.
std::vector<Change> changes_for_stock_copy(const Unit& unit, const clang::CallExpr* call, unsigned argument);

}  // namespace tzc::rewriter
