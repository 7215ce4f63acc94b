// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Type.h>

#include <string>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// What a library that gets an object of the type, beside elements of a message, may hand one of these to, in words: a function that
/// the object leads to, or a class of the package that it holds or points to, by one of its constructors or operators. Empty: to no
/// code of the package. `element`: the type of the elements; null: it is not known.
std::string passes_elements_to(const Unit& unit, clang::QualType type, clang::QualType element);

}  // namespace tzc::rewriter
