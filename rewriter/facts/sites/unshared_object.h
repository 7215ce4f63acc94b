// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Objects that are being made, and that no other thread knows of yet.

#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Whether this unit has the definitions of all member functions of a class, and no friends are declared.
bool is_seen_whole(const clang::CXXRecordDecl* record);

/// Whether a mention of a field or variable stands where no other thread can look at it in a program without data races: in a constructor of
/// its class, in a private function that only these call, or in main; and what runs before it there has told nobody, or nobody waits
/// for what comes later.
bool is_made_here(const Unit& unit, const clang::Expr* mention, const clang::ValueDecl* named);

}  // namespace tzc::rewriter
