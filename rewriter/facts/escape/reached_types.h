// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/DeclCXX.h>

namespace tzc::rewriter {

/// The type that a class names so; null: it names none.
clang::QualType named_in(const clang::CXXRecordDecl* record, llvm::StringRef name);

/// A pointer, array or iterator to elements that are, or hold, pointers; an owner of some, or a reference to an object of a class.
bool reaches_pointers(clang::QualType type);

/// std::pair<It, int> and the like: the one view that makes, of what it is given, what its own type says.
bool is_pair(clang::QualType type);
/// A pointer or reference to an array, or a pair with one.
bool points_to_array(clang::QualType type);

}  // namespace tzc::rewriter
