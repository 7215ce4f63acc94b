// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facts/escape/escape.h"
#include "facts/escape/written_types.h"

namespace tzc::rewriter {

/// One reference on its way up. Each step returns whether to go on climbing.
class ClimbState {
 protected:
  ClimbState(EscapeContext& context, const FunctionView& view, EscapeAnalysis& analysis, Referring from)
      : context_(context), view_(view), analysis_(analysis), at_(std::move(from)) {}

  bool done() const { return false; }
  bool go_on(const clang::Expr* next) {
    at_.expr = next;
    return true;
  }
  bool go_on(const clang::Expr* next, Reference how) {
    at_.how = how;
    return go_on(next);
  }
  /// An array that went elsewhere may be exchanged there; what points to its elements would go with it.
  bool escape(const std::string& how) { return escape(how, at_.how != Reference::array); }
  bool escape(const std::string& how, bool ends_with_scope) {
    analysis_.escape(at_.messages, how, at_.expr->getBeginLoc(), ends_with_scope);
    return false;
  }
  bool hold(const clang::VarDecl* variable) {
    analysis_.hold(view_, {variable, at_.how, at_.read_only, at_.messages});
    return false;
  }
  /// A new array with the elements of the message's.
  bool is_copy() const {
    return at_.how == Reference::array && at_.expr->isPRValue() && is_data_array(at_.expr->getType());
  }
  /// Whether what is initialised with the array gets its type from it: a copy is one of another class in the port.
  bool gives_type(clang::QualType target) const {
    return at_.how == Reference::array && !is_written_out(context_.unit.ast(), target);
  }
  /// Behind a type that does not name it, the program may expect a std::vector: no lifetime excuses that. The climb goes on all the
  /// same, since const may be cast away there.
  void escape_as(clang::QualType type) {
    escape("becomes a '" + type.getAsString() + "', which does not tell that an array lies there", false);
  }
  /// Into a local variable of its own, or elsewhere.
  bool into_assignment(const clang::Expr* target);

  EscapeContext& context_;
  const FunctionView& view_;
  EscapeAnalysis& analysis_;
  Referring at_;
};

/// The steps through calls, member functions and constructors.
class CallSteps : protected ClimbState {
 protected:
  using ClimbState::ClimbState;

  bool into_member(const clang::MemberExpr* member);
  bool into_operator(const clang::CXXOperatorCallExpr* call);
  bool into_call(const clang::CallExpr* call);
  bool into_construction(const clang::CXXConstructExpr* construct);

 private:
  bool into_array_method(const clang::MemberExpr* member, const clang::CXXMemberCallExpr* call);
  bool into_element_method(const clang::CXXMemberCallExpr* call);
  bool into_object_operator(const clang::CXXOperatorCallExpr* call);
  bool changes_type() const;
  bool makes_element(const clang::CallExpr* call) const;
  bool into_copy(const clang::CXXConstructExpr* construct);
  bool escape_to_question(const std::string& function);
  bool escape_into_call(const std::string& how);
  void check_pair(clang::QualType made);
  bool into_known_call(const clang::CallExpr* call, bool result_is_new);
  /// The value of a call: part of what it was given, when its type can be.
  bool into_result(const clang::Expr* call);
  /// What the array takes over, or exchanges its elements with.
  void check_taken(const clang::Expr* value, bool swapped);
  bool may_store_pointer(const clang::CallExpr* call);
  void check_callables(const clang::CallExpr* call);
  bool check_passed(clang::QualType type);
  void hold_parameters(const clang::LambdaExpr* lambda);
};

/// The steps through statements and other expressions. Each step is understood, or is an escape.
class Climber : private CallSteps {
 public:
  Climber(EscapeContext& context, const FunctionView& view, EscapeAnalysis& analysis, const Referring& from)
      : CallSteps(context, view, analysis, from) {}

  /// The first expression that refers to elements; null: it went through the array alone.
  Referring run() {
    Referring born;
    do
      if (!born.expr && at_.how != Reference::array) born = at_;
    while (step());
    return born;
  }

 private:
  bool step();
  bool step_up();
  bool into_root();
  bool into_statement(const clang::Stmt* parent);
  bool into_expression(const clang::Expr* parent);
  bool into_declaration(const clang::DeclStmt* declaration);
  bool into_implicit_cast(const clang::ImplicitCastExpr* cast);
  bool into_explicit_cast(const clang::ExplicitCastExpr* cast);
  bool is_renamed(const clang::VarDecl* variable) const;
  bool into_unary(const clang::UnaryOperator* op);
  bool into_binary(const clang::BinaryOperator* op);
  bool into_list(const clang::InitListExpr* list);
  bool into_lambda(const clang::LambdaExpr* lambda);
  bool into_return(const clang::ReturnStmt* stmt);
  const clang::VarDecl* capture_of(const clang::LambdaExpr* lambda) const;
  bool into_type_question();
  bool is_value_of_statements(const clang::Stmt* value) const;
  bool is_used_up(const clang::LambdaExpr* lambda) const;
};

}  // namespace tzc::rewriter
