// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include "facts/content/content_log.h"
#include "facts/syntax/function_view.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Reads after which statements of a function the names of elements denote other ones: an index, iterator or container has
/// changed.
class MovedElements {
 public:
  MovedElements(const Unit& unit, const FunctionView& view, const MessageParts& parts, ContentLog& log)
      : unit_(unit), view_(view), parts_(parts), log_(log) {}

  void look_at(const clang::Stmt* stmt);
  /// The function, or closure, is called.
  void entered(const clang::FunctionDecl* function);

 private:
  void index(const clang::VarDecl* variable);
  void stepped(const clang::Expr* operand);
  void container(const clang::Expr* expr);

  const Unit& unit_;
  const FunctionView& view_;
  const MessageParts& parts_;
  ContentLog& log_;
};

}  // namespace tzc::rewriter
