// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Decl.h>

namespace tzc::rewriter {

/// Whether a variable may hold something else than what it began with: its function assigns it, or gives it to what may write to it. Of one
/// that lasts, anybody may change what it holds.
bool may_change_later(const clang::VarDecl* variable);

}  // namespace tzc::rewriter
