// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <set>
#include <string>
#include <vector>

#include "facts/function_view.h"
#include "facts/message_parts.h"
#include "facts/unit.h"
#include "model/content_flow.h"

namespace tzc::rewriter {

/// Reads what the statements of one function do to the content of messages.
class ContentReader {
 public:
  ContentReader(const Unit& unit, const FunctionView& view) : unit_(unit), view_(view), parts_(unit, view) {}

  std::vector<ContentEvent> events_of(const clang::Stmt* stmt) {
    events_.clear();
    look_at(stmt);
    return std::move(events_);
  }

 private:
  void look_at(const clang::Stmt* stmt);
  void array(const clang::Expr* expr);
  void array_of_messages(const clang::Expr* expr);
  void replaced(const clang::Expr* array, const clang::Expr* source);
  void exchanged(const clang::Expr* one, const clang::Expr* other, clang::SourceLocation where);
  void pair(ContentEvent::Kind kind, MessagePart part, MessagePart other, clang::SourceLocation where);
  void array_method(const clang::Expr* array, const clang::CXXMemberCallExpr* call, const std::string& name);
  void declaration(const clang::DeclStmt* stmt);
  void assignment(const clang::CXXOperatorCallExpr* call);
  void pointer_assignment(const clang::BinaryOperator* op);
  void returned(const clang::ReturnStmt* stmt);
  void member_call(const clang::CXXMemberCallExpr* call);
  void iterator(const clang::CXXConstructExpr* construct);
  void made(const clang::CXXRecordDecl* record, clang::SourceLocation where);
  void publish(const clang::CXXMemberCallExpr* call);
  bool rule_call(const clang::CallExpr* call, const std::string& name);
  void package_call(const clang::FunctionDecl* function, llvm::ArrayRef<const clang::Expr*> arguments,
                    const clang::Stmt* at);
  void closure(const clang::LambdaExpr* lambda);
  void add(ContentEvent::Kind kind, MessagePart part, clang::SourceLocation where) {
    if (part.empty()) return;
    ContentEvent event;
    event.kind = kind;
    event.part = std::move(part);
    event.where = unit_.location(where);
    events_.push_back(std::move(event));
  }

  const Unit& unit_;
  const FunctionView& view_;
  MessageParts parts_;
  std::vector<ContentEvent> events_;
  std::set<const clang::LambdaExpr*> open_;
};

}  // namespace tzc::rewriter
