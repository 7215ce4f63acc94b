// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

#include <vector>

#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// `Image image = *cv_image.toImageMsg();` with a move in place of the copy: the pointer ends with the statement, and nobody else has one.
/// Empty: a message does not start so, or a macro writes it.
std::vector<Change> move_out_of_result(const Unit& unit, const clang::Expr* initializer);

}  // namespace tzc::rewriter
