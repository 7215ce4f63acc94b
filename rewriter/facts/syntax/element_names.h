// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

#include <string>

#include "facts/syntax/function_view.h"
#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// What an index or key tells about the element that it leads to: "3", "i - 1@120@" with the variables that it depends on
/// (index_token), or any_element(): another time it may lead to another element.
std::string element_name(const Unit& unit, const FunctionView& view, const clang::Expr* index);

/// Stands in the names of the elements that depend on a variable: "@120@", or on a member or global, "@!c:...@".
std::string index_token(const Unit& unit, const clang::ValueDecl* variable);

/// Whether elements may be named after the local variable or parameter.
bool is_index(const FunctionView& view, const clang::VarDecl* variable);

/// The member of the function's own object, or global, that an expression denotes and elements may be named after; null: it
/// denotes none.
const clang::ValueDecl* lasting_index(const clang::Expr* expr);

/// Whether a mention of it only reads it.
bool is_read(const FunctionView& view, const clang::Expr* mention);

}  // namespace tzc::rewriter
