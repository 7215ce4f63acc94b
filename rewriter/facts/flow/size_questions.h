// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>
#include <clang/AST/Type.h>

#include "facts/flow/entity_table.h"
#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// sizeof, alignof or offsetof a class of the package: the messages in it may not change their size.
void note_size_question(const Unit& unit, EntityTable& entities, clang::QualType type,
                        clang::SourceLocation where);

/// __PRETTY_FUNCTION__: of the messages, publishers and filters that the function's parameters and its result are, and of those of the
/// functions that it stands in.
void note_signature_question(const Unit& unit, EntityTable& entities, const clang::PredefinedExpr* name);

}  // namespace tzc::rewriter
