// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Decl.h>

namespace tzc::rewriter {

/// Whether what runs may be another body than the one that this unit has. C++ promises that a function has one definition (or, if it is
/// inline or an instance of a template, that all are the same), but not of one that is weak, of GNU's `extern inline`, whose body is only
/// for inlining, and of one that has a body for each processor. Such a function counts as one without a body wherever a body is looked for
/// to see what a call does; what stands in the body is looked at all the same, since it may run.
bool may_have_another_body(const clang::FunctionDecl* function);

/// What runs when the function is called, unless it is overridden; null: this unit does not show it.
const clang::FunctionDecl* shown_body(const clang::FunctionDecl* function);

}  // namespace tzc::rewriter
