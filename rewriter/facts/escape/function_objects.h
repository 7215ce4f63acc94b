// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Type.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Whether a library that gets an object of the type, beside elements of a message, may hand one of these to code of the package:
/// to a function that the object leads to, or to a constructor or operator of what it holds or points to.
bool may_pass_elements(const Unit& unit, clang::QualType type);

}  // namespace tzc::rewriter
