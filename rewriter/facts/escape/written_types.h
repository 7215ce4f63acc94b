// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Type.h>

namespace clang {
class ASTContext;
}

namespace tzc::rewriter {

/// Whether the source names the type itself. Otherwise it follows from the type of a value: auto, decltype, or a parameter of a
/// template that stands for it.
bool is_written_out(const clang::ASTContext& ast, clang::QualType type);

}  // namespace tzc::rewriter
