// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/DeclCXX.h>

#include <vector>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Whether a pointer that is initialised so leads to a new message: new Image, make_shared<Image>(). One of two ways is enough: the other
/// leads to a message that has been published, or to none.
bool starts_with_new_message(const clang::Expr* initializer);

/// The pointers of an object that start with new messages, in whichever way it is made; those of its parts, too. A constructor that is
/// not seen may make any.
std::vector<const clang::FieldDecl*> started_pointers(const Unit& unit, const clang::CXXRecordDecl* record);

}  // namespace tzc::rewriter
