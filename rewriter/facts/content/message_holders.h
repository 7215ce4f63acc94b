// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "facts/syntax/function_view.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Names what holds a message, or leads to it, in a function: a variable, a container, a function's result.
class MessageHolders {
 public:
  MessageHolders(const Unit& unit, const FunctionView& view);

  /// The root of what the expression is a part of; empty: not known.
  std::string of(const clang::Expr* expr, unsigned depth = 0) const;
  std::string of_name(const clang::VarDecl* variable, unsigned depth = 0) const;

 private:
  std::string of_call(const clang::CallExpr* call, unsigned depth) const;
  const clang::Expr* leads_to(const clang::VarDecl* variable) const;
  std::string unique(const clang::ValueDecl* decl) const;

  const Unit& unit_;
  const FunctionView& view_;
  const MessageParts parts_;
  const std::string function_;  ///< its USR
};

/// What an expression leads on to without making another object; null: it is a name, a call, or something else.
const clang::Expr* operand_of(const clang::Expr* expr);

}  // namespace tzc::rewriter
