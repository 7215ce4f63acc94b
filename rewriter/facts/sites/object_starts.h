// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

#include <optional>

#include "facts/flow/flow_uses.h"

namespace tzc::rewriter {

/// The lasting pointer that starts with an object whose value ends there: a member of an object that subscribes or holds the node, by a
/// constructor's initializer list or its own initializer, a global or a static. None: it ends elsewhere, or in a container, among whose elements
/// nothing tells it apart.
std::optional<LastingStart> lasting_start(const FlowEnd& end);

/// Whether the value is made whenever the statement is executed, and whatever it ends in has it afterwards.
bool is_always_made(const Unit& unit, const clang::Expr* made);

/// Node() : image_(new Image) {}
bool is_in_initializer_list(const Unit& unit, const clang::Expr* made);

}  // namespace tzc::rewriter
