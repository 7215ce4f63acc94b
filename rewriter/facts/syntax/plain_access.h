// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/DeclCXX.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Whether a function of a library leads to what an object holds, or says how much that is, and runs nothing of what it holds, whatever that is:
/// `*pointer`, `vector[i]`, `list.begin()`, `++iterator`, `pointer == nullptr`. Such a function makes, copies, compares and ends no element. A map's
/// `[]` is none: it compares keys, and makes what it does not find.
bool is_plain_access(const Unit& unit, const clang::FunctionDecl* function);

}  // namespace tzc::rewriter
