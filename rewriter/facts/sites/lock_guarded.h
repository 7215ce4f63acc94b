// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether another thread may change what a name means, held off by nothing but a lock:
//   { std::lock_guard<std::mutex> lock(mutex_); pub_ = nh_.advertise<Image>("image", 1); }
// Then the name may not be looked at before the lock under which the source does.

#include <clang/AST/Decl.h>
#include <clang/AST/Expr.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// True unless the whole program is seen to change the variable or field only where it makes it (is_made_here).
bool may_be_lock_guarded(const Unit& unit, const clang::ValueDecl* named);

/// Whether this mention changes, or may change, what others can see already: not where it is made, nor a variable of the function.
bool changes_what_others_see(const Unit& unit, const clang::Expr* mention, const clang::ValueDecl* named);

}  // namespace tzc::rewriter
