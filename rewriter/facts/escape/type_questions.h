// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <vector>

#include "facts/escape/escape_context.h"
#include "facts/syntax/function_view.h"

namespace tzc::rewriter {

/// Where a function asks for a type that is another one in the port: an array's, its iterator's, or that of what is made of either.
/// Each is a question about every message that the function names (`messages_named`), since what is asked about may have come from any.
std::vector<const clang::Expr*> type_questions(const Unit& unit, const FunctionView& view);

/// Whether a type is another one in the port, because it is an array's, its iterator's, or names one: std::pair<It, It>.
bool is_made_of_array(clang::QualType type);

std::vector<EntityId> messages_named(EscapeContext& context, const FunctionView& view);

}  // namespace tzc::rewriter
