// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Decl.h>
#include <clang/AST/Expr.h>
#include <clang/AST/ExprCXX.h>

#include <map>
#include <unordered_map>
#include <vector>

namespace tzc::rewriter {

/// One function's body, implicit code included, as a tree with parents and in the order of the source.
///
/// Clang's own parent map does not know the instances of generic lambdas, nor through which of several
/// parents a shared node is reached. Conclusions about a function must depend on neither.
class FunctionView {
 public:
  /// When a statement begins and ends in the order of the source.
  struct Span {
    unsigned enter = 0;
    unsigned exit = 0;
    bool contains(const Span& other) const { return enter <= other.enter && other.exit <= exit; }
  };

  /// `definition` has a body. Initializers of a constructor come before it.
  explicit FunctionView(const clang::FunctionDecl* definition);

  const clang::FunctionDecl* function() const { return function_; }
  /// Every statement and expression, outer ones first.
  const std::vector<const clang::Stmt*>& statements() const { return statements_; }
  /// Whether the statement or expression is one of them; what is not evaluated, as the operand of decltype, is none.
  bool holds(const clang::Stmt* stmt) const { return nodes_.count(stmt) != 0; }
  /// Null for the body and for a constructor's initializers.
  const clang::Stmt* parent(const clang::Stmt* stmt) const;
  Span span(const clang::Stmt* stmt) const;
  /// The outermost expression around an expression.
  const clang::Stmt* full_expression(const clang::Stmt* stmt) const;
  /// The innermost lambda whose body holds the statement; null: the function's own code.
  const clang::LambdaExpr* lambda_around(const clang::Stmt* stmt) const;
  /// Whether `inner` is `outer` or a lambda inside it. Null is the function's own code.
  bool runs_within(const clang::LambdaExpr* inner, const clang::LambdaExpr* outer) const;
  /// The parts of loops that run again and again: condition, increment and body.
  const std::vector<Span>& repeated() const { return repeated_; }
  /// The field that an expression without a parent initializes; null: none.
  const clang::CXXCtorInitializer* initializer(const clang::Stmt* stmt) const;
  /// The statement that declares the variable; null: it is a parameter or of another function.
  const clang::DeclStmt* declaration(const clang::VarDecl* variable) const;
  const std::vector<const clang::DeclRefExpr*>& uses(const clang::ValueDecl* decl) const;
  /// Has goto, labels or parallel regions: the order of the source is not the order of execution.
  bool jumps() const { return jumps_; }

 private:
  void walk(const clang::Stmt* stmt, const clang::Stmt* parent, const clang::LambdaExpr* lambda);
  void note(const clang::Stmt* stmt);
  void note_loop(const clang::Stmt* stmt);

  struct Node {
    const clang::Stmt* parent;
    const clang::LambdaExpr* lambda;
    Span span;
  };
  const clang::FunctionDecl* function_;
  std::vector<const clang::Stmt*> statements_;
  std::unordered_map<const clang::Stmt*, Node> nodes_;
  std::map<const clang::ValueDecl*, std::vector<const clang::DeclRefExpr*>> uses_;
  std::map<const clang::VarDecl*, const clang::DeclStmt*> declarations_;
  std::map<const clang::Stmt*, const clang::CXXCtorInitializer*> initializers_;
  std::vector<Span> repeated_;
  unsigned clock_ = 0;
  bool jumps_ = false;
};

}  // namespace tzc::rewriter
