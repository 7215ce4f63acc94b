// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include "facts/content/content_log.h"
#include "facts/syntax/function_view.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Reads which names statements of a function give to messages: variables, pointers, references, iterators, what holds such,
/// and what the function returns.
class ContentNames {
 public:
  ContentNames(const Unit& unit, const FunctionView& view, const MessageParts& parts, ContentLog& log)
      : unit_(unit), view_(view), parts_(parts), log_(log) {}

  void look_at(const clang::Stmt* stmt);
  /// An object's member comes into being.
  void member(const clang::FieldDecl* field, const clang::Expr* init);

 private:
  void variable(const clang::VarDecl* variable);
  void captured(const clang::LambdaExpr* lambda);
  void made_from(const clang::VarDecl* variable, const MessagePart& root);
  void assignment(const clang::CXXOperatorCallExpr* call);
  void returned(const clang::ReturnStmt* stmt);
  void choice(const clang::Expr* expr, llvm::ArrayRef<const clang::Expr*> ways);
  void library_call(const clang::CallExpr* call);
  void aggregate(const clang::InitListExpr* list);
  void alias(MessagePart pointer, const clang::Expr* to);
  void may_lead_to(const MessagePart& name, const clang::Expr* source);

  const Unit& unit_;
  const FunctionView& view_;
  const MessageParts& parts_;
  ContentLog& log_;
};

/// array = std::move(vector), array = function()
bool takes_elements(const clang::CXXOperatorCallExpr* assignment);
/// std::vector<T>(), {}
bool is_made_empty(const clang::Expr* source);

}  // namespace tzc::rewriter
