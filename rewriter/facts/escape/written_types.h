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

/// Whether it names what lies behind references and pointers: const std::vector<float>&, and not auto&.
bool is_pointee_written_out(const clang::ASTContext& ast, clang::QualType type);

/// Whether values of a type are, or say that they refer or point to, a message's array: std::vector<float>* and the like.
bool names_array(clang::QualType type);

}  // namespace tzc::rewriter
