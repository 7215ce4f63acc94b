// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What iterators and containers say of their elements.

#include <clang/AST/DeclCXX.h>

namespace tzc::rewriter {

/// The type that a class names so, as `value_type`; null: it names none.
clang::QualType named_in(const clang::CXXRecordDecl* record, llvm::StringRef name);
/// Of a library, and known: its operators compare it, or give another one, or a distance.
bool is_known_iterator(clang::QualType type);
/// Of what elements a reference to an array or element, a pointer, or a known iterator is one; null: of any.
clang::QualType element_type(clang::QualType reference);
/// A pointer, array or iterator to elements that are, or hold, pointers; an owner of some, or a reference to an object of a class.
bool reaches_pointers(clang::QualType type);

}  // namespace tzc::rewriter
