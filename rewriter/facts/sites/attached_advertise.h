// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where the package advertises with a publisher that keeps its class: shared memory can be attached to its topic.

#include <clang/AST/Expr.h>

#include <string>
#include <vector>

#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// The edits that put text around an expression; empty: a macro writes it.
std::vector<Change> put_around(const Unit& unit, const clang::Expr* expr, const Change& before,
                               const std::string& behind);

/// Describes how the site can be attached while its publisher keeps its class, or that an earlier run did so. Then its changes, by which the
/// publisher gets another class, take that call away.
void describe_keeping(Advertise& site, const Unit& unit, const clang::CallExpr* call);

}  // namespace tzc::rewriter
