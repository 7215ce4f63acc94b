// SPDX-License-Identifier: BSD-3-Clause
#include "facts/ast_walk.h"
#include "facts/content_reader.h"
#include "facts/message_type.h"

namespace tzc::rewriter {
namespace {

/// Whether the call is one of the closure that the expression denotes.
bool calls(const clang::CXXOperatorCallExpr* call, const clang::Stmt* closure) {
  return call->getOperator() == clang::OO_Call && call->getArg(0) == closure;
}

/// Whether a closure is called directly, or by a library's function that it is an argument of, and by nothing else.
bool is_called_here(const FunctionView& view, const clang::LambdaExpr* lambda) {
  const clang::Stmt* inner = lambda;
  const clang::Stmt* around = view.parent(lambda);
  while (around &&
         (is_implicit_wrapper(around) || llvm::isa<clang::CastExpr, clang::CXXConstructExpr>(around))) {
    inner = around;
    around = view.parent(around);
  }
  if (const auto* op = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(around)) return calls(op, inner);
  if (const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(around))
    return !message_sources(call).empty();
  const auto* declaration = llvm::dyn_cast_or_null<clang::DeclStmt>(around);
  const auto* variable = declaration && declaration->isSingleDecl()
                             ? llvm::dyn_cast<clang::VarDecl>(declaration->getSingleDecl())
                             : nullptr;
  if (!variable || variable->getType()->getAsCXXRecordDecl() != lambda->getLambdaClass()) return false;
  return llvm::all_of(view.uses(variable), [&](const clang::DeclRefExpr* use) {
    const clang::Stmt* given = use;
    const clang::Stmt* user = view.parent(use);
    while (user && is_implicit_wrapper(user)) {
      given = user;
      user = view.parent(user);
    }
    const auto* op = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(user);
    return op && calls(op, given);
  });
}

/// Tells which of a closure's statements may not be run, as they are looked at in the order of the source.
class Branches {
 public:
  Branches(const FunctionView& view, ContentLog& log, const clang::LambdaExpr* lambda)
      : view_(view), log_(log), lambda_(lambda) {}
  Branches(const Branches&) = delete;
  Branches& operator=(const Branches&) = delete;
  ~Branches() {
    for (; !open_.empty(); open_.pop_back()) log_.end();
  }

  void before(const clang::Stmt* stmt) {
    const FunctionView::Span span = view_.span(stmt);
    for (; !open_.empty() && !open_.back().contains(span); open_.pop_back()) log_.end();
    if (is_branch(stmt)) begin(span);
  }

  /// return, break: what comes behind, in the closure or the loop, may have been left out.
  void after(const clang::Stmt* stmt) {
    if (llvm::isa<clang::ReturnStmt, clang::GotoStmt, clang::CXXThrowExpr>(stmt)) begin(view_.span(lambda_));
    if (!llvm::isa<clang::BreakStmt, clang::ContinueStmt>(stmt)) return;
    const clang::Stmt* around = view_.parent(stmt);
    while (around && !llvm::isa<clang::ForStmt, clang::WhileStmt, clang::DoStmt, clang::CXXForRangeStmt,
                                clang::SwitchStmt, clang::LambdaExpr>(around))
      around = view_.parent(around);
    if (around) begin(view_.span(around));
  }

 private:
  /// Outer ones stay open as long.
  void begin(const FunctionView::Span& span) {
    for (FunctionView::Span& outer : open_)
      if (span.contains(outer)) outer = span;
    open_.push_back(span);
    log_.begin();
  }

  bool is_branch(const clang::Stmt* stmt) const {
    const clang::Stmt* around = view_.parent(stmt);
    if (llvm::isa_and_nonnull<clang::IfStmt, clang::SwitchStmt, clang::ForStmt, clang::WhileStmt,
                              clang::CXXForRangeStmt, clang::AbstractConditionalOperator,
                              clang::CXXCatchStmt>(around))
      return true;
    const auto* op = llvm::dyn_cast_or_null<clang::BinaryOperator>(around);
    return op && op->isLogicalOp() && op->getRHS() == stmt;
  }

  const FunctionView& view_;
  ContentLog& log_;
  const clang::LambdaExpr* lambda_;
  std::vector<FunctionView::Span> open_;
};

/// Somebody else may call the closure, with any message that it may write to.
void any_given_to(const clang::LambdaExpr* lambda, const FunctionView& view, ContentLog& log) {
  if (is_called_here(view, lambda)) return;
  for (const clang::ParmVarDecl* parameter : lambda->getCallOperator()->parameters()) {
    const clang::QualType type = parameter->getType(), pointee = pointee_of(type);
    const bool is_const = (pointee.isNull() ? type.getNonReferenceType() : pointee).isConstQualified();
    if (is_const || !is_name_of_message(type)) continue;
    log.add(ContentEvent::Kind::any, any_message(message_reached(type)->name), lambda->getBeginLoc());
  }
}

}  // namespace

/// A closure may be called where it is made, and again: its body's events, twice, in the order of the source.
void ContentReader::closure(const clang::LambdaExpr* lambda) {
  if (!open_.insert(lambda).second) return;
  any_given_to(lambda, view_, log_);
  moved_.entered(lambda->getCallOperator());
  for (int time = 0; time < 2; ++time) {
    Branches branches(view_, log_, lambda);
    for (const clang::Stmt* stmt : view_.statements()) {
      if (view_.lambda_around(stmt) != lambda) continue;
      branches.before(stmt);
      look_at(stmt);
      branches.after(stmt);
    }
  }
  open_.erase(lambda);
}

/// The closure of this function that a call calls; null: it calls none.
const clang::LambdaExpr* ContentReader::called_closure(const clang::CallExpr* call) const {
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call);
  const clang::FunctionDecl* function =
      op && op->getOperator() == clang::OO_Call ? op->getDirectCallee() : nullptr;
  if (!function) return nullptr;
  for (const clang::Stmt* stmt : view_.statements())
    if (const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt))
      if (lambda->getCallOperator() == function) return lambda;
  return nullptr;
}

/// What a closure does to the messages that it is given.
void ContentReader::closure_of(const clang::LambdaExpr* lambda,
                               llvm::ArrayRef<const clang::Expr*> arguments) {
  const std::size_t first = log_.size();
  closure(lambda);
  const auto& parameters = lambda->getCallOperator()->parameters();
  for (std::size_t i = 0; i < parameters.size() && i < arguments.size(); ++i) {
    if (!is_name_of_message(parameters[i]->getType())) continue;
    log_.any(arguments[i]);
    if (const MessagePart part = parts_.part_of(arguments[i]); !part.empty())
      log_.rename(first, parts_.root_of(parameters[i]), part);
  }
}

/// std::for_each(begin, end, [](Image& image) { ... }): a library gives a closure what it was given itself.
void ContentReader::closures_called_by(const clang::CallExpr* call) {
  const std::vector<const clang::Expr*> sources = message_sources(call);
  for (const clang::Expr* argument : call->arguments()) {
    const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(argument->IgnoreUnlessSpelledInSource());
    if (!lambda) continue;
    const std::size_t parameters = lambda->getCallOperator()->getNumParams();
    for (const clang::Expr* source : sources)
      closure_of(lambda, std::vector<const clang::Expr*>(parameters, source));
  }
}

}  // namespace tzc::rewriter
