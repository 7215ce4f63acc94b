// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <string>
#include <vector>

#include "facts/content/content_closures.h"
#include "facts/content/content_log.h"
#include "facts/content/content_names.h"
#include "facts/content/ended_objects.h"
#include "facts/content/moved_elements.h"
#include "facts/escape/escape_context.h"
#include "facts/escape/unknown_calls.h"
#include "facts/syntax/function_view.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/unit.h"
#include "model/content_flow.h"

namespace tzc::rewriter {

/// Reads what the statements of one function do to the content of messages.
class ContentReader {
 public:
  ContentReader(EscapeContext& context, const FunctionView& view, UnknownCalls unknown)
      : unit_(context.unit),
        view_(view),
        unknown_(std::move(unknown)),
        parts_(context.unit, view),
        log_(context.unit, context.flow, parts_),
        names_(context.unit, view, parts_, log_),
        moved_(context.unit, view, parts_, log_),
        closures_(view, parts_, log_),
        ended_(context.unit, log_) {}
  ContentReader(const ContentReader&) = delete;
  ContentReader& operator=(const ContentReader&) = delete;

  std::vector<ContentStep> steps_of(const clang::Stmt* stmt) {
    look_at(stmt);
    if (unknown_.at_end_of_scopes()) log_.step(UnknownCall{});
    return log_.take();
  }
  /// What a call of the function, or closure, does before its first statement.
  std::vector<ContentStep> steps_of(const clang::FunctionDecl* function) {
    moved_.entered(function);
    return log_.take();
  }
  /// What a constructor's initializer does.
  std::vector<ContentStep> steps_of(const clang::CXXCtorInitializer* initializer) {
    if (initializer->getMember()) names_.member(initializer->getMember(), initializer->getInit());
    return log_.take();
  }
  /// What the end of a variable does.
  std::vector<ContentStep> steps_at_end_of(const clang::VarDecl* variable) {
    ended_.object(variable->getType(), variable->getLocation());
    if (const auto runs = unknown_.at_end_of(variable)) ended_in_library(variable->getType(), *runs);
    return log_.take();
  }
  /// What the end of a destructor's object does behind its body.
  std::vector<ContentStep> steps_at_end_of_parts(const clang::FunctionDecl* destructor) {
    if (const auto runs = unknown_.at_end_of_parts(destructor)) log_.step(UnknownCall{*runs});
    return log_.take();
  }

 private:
  void look_at(const clang::Stmt* stmt);
  void ended_in_library(clang::QualType type, const IfShown& runs);
  void mention(const clang::Expr* expr);
  void array(const clang::Expr* expr);
  void array_assigned(const clang::CXXOperatorCallExpr* op);
  void array_of_messages(const clang::Expr* expr);
  void replaced(const clang::Expr* array, const clang::Expr* source);
  void exchanged(const clang::Expr* one, const clang::Expr* other, clang::SourceLocation where);
  void array_method(const clang::Expr* array, const clang::CXXMemberCallExpr* call, const std::string& name);
  void member_call(const clang::CXXMemberCallExpr* call);
  void made(const clang::CXXRecordDecl* record, const clang::CXXConstructorDecl* by,
            clang::SourceLocation where);
  void moved_whole(const clang::Stmt* stmt);
  void publish(const clang::CallExpr* call);
  bool rule_call(const clang::CallExpr* call, const std::string& name);
  void package_call(const clang::FunctionDecl* function, llvm::ArrayRef<const clang::Expr*> arguments,
                    const clang::Stmt* at);

  const Unit& unit_;
  const FunctionView& view_;
  const UnknownCalls unknown_;
  MessageParts parts_;
  ContentLog log_;
  ContentNames names_;
  MovedElements moved_;
  ContentClosures closures_;
  EndedObjects ended_;
};

}  // namespace tzc::rewriter
