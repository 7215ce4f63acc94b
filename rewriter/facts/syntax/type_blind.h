// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Decl.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/Expr.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// __PRETTY_FUNCTION__ and its likes: the text has the types of the function's signature. Where a library's macro writes it, it is for the log.
bool tells_signature(const Unit& unit, const clang::PredefinedExpr* name);

/// Whether the instance of a template does the same whatever the type of the argument: its pattern asks for no
/// trait, size or name of a type, keeps no static of its own, and names no template of the package with the type. True for functions that are no instances and
/// for parameters whose type does not depend on the template's arguments.
bool is_type_blind(const Unit& unit, const clang::FunctionDecl* function, unsigned argument);

/// The same of all that a class template of the package does with its arguments.
bool is_type_blind(const Unit& unit, const clang::ClassTemplateSpecializationDecl* instance);

}  // namespace tzc::rewriter
