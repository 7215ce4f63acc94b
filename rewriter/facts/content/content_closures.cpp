// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/content_closures.h"

#include "facts/flow/deleters.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/message_type.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

/// Whether the expression's only use is that it is called.
bool is_called(const FunctionView& view, const clang::Stmt* closure) {
  const clang::Stmt* around = view.parent(closure);
  while (around && is_implicit_wrapper(around)) {
    closure = around;
    around = view.parent(around);
  }
  const auto* op = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(around);
  return op && op->getOperator() == clang::OO_Call && op->getArg(0) == closure;
}

/// What gets a closure, behind conversions and copies.
const clang::Stmt* receiver_of(const FunctionView& view, const clang::LambdaExpr* lambda) {
  const clang::Stmt* around = view.parent(lambda);
  while (around &&
         (is_implicit_wrapper(around) || llvm::isa<clang::CastExpr, clang::CXXConstructExpr>(around)))
    around = view.parent(around);
  return around;
}

/// The variable that holds a closure and nothing else; null: there is none.
const clang::VarDecl* variable_of(const FunctionView& view, const clang::LambdaExpr* lambda) {
  const auto* declaration = llvm::dyn_cast_or_null<clang::DeclStmt>(receiver_of(view, lambda));
  const auto* variable = declaration && declaration->isSingleDecl()
                             ? llvm::dyn_cast<clang::VarDecl>(declaration->getSingleDecl())
                             : nullptr;
  const bool is_it = variable && variable->getType()->getAsCXXRecordDecl() == lambda->getLambdaClass();
  return is_it ? variable : nullptr;
}

/// Whether a closure is called directly, and by nothing else.
bool is_only_called(const FunctionView& view, const clang::LambdaExpr* lambda) {
  if (is_called(view, lambda)) return true;
  const clang::VarDecl* const variable = variable_of(view, lambda);
  return variable && llvm::all_of(view.uses(variable),
                                  [&](const clang::DeclRefExpr* use) { return is_called(view, use); });
}

/// Whether a call gets the closure together with messages: what it gives the closure is among those.
bool is_given_with_messages(const FunctionView& view, const clang::LambdaExpr* lambda) {
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(receiver_of(view, lambda));
  return call && !message_sources(call).empty();
}

/// Somebody else may call the closure, with any message that it may write to.
void any_given_to(const clang::FunctionDecl* body, ContentLog& log) {
  for (const clang::ParmVarDecl* parameter : body->parameters()) {
    const clang::QualType type = parameter->getType(), pointee = pointee_of(type);
    const bool is_const = (pointee.isNull() ? type.getNonReferenceType() : pointee).isConstQualified();
    if (is_const || !is_name_of_message(type)) continue;
    log.add(ContentEvent::Kind::any, any_message(message_reached(type)->name), body->getBeginLoc());
  }
}

class VariableFinder : public AstVisitor {
 public:
  bool VisitVarDecl(clang::VarDecl* variable) override {
    const clang::QualType type = variable->getType();
    if (variable->hasLocalStorage() && (message_reached(type) || is_name_of_array(type) || is_iterator(type)))
      found.push_back(variable);
    return true;
  }
  std::vector<const clang::VarDecl*> found;
};

}  // namespace

std::vector<const clang::FunctionDecl*> bodies_of(const clang::LambdaExpr* lambda) {
  std::vector<const clang::FunctionDecl*> bodies;
  const clang::FunctionTemplateDecl* const pattern =
      lambda->getLambdaClass()->getDependentLambdaCallOperator();
  if (!pattern && !lambda->getCallOperator()->isDependentContext())
    bodies.push_back(lambda->getCallOperator());
  if (pattern)
    for (const clang::FunctionDecl* instance : pattern->specializations())
      if (instance->doesThisDeclarationHaveABody() && !instance->isDependentContext())
        bodies.push_back(instance);
  return bodies;
}

std::vector<const clang::FunctionDecl*> bodies_run_elsewhere(const FunctionView& view) {
  std::vector<const clang::FunctionDecl*> found;
  for (const clang::Stmt* stmt : view.statements()) {
    const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt);
    if (!lambda) continue;
    const bool is_run_elsewhere = !is_only_called(view, lambda);
    for (const clang::FunctionDecl* body : bodies_of(lambda)) {
      if (is_run_elsewhere) found.push_back(body);
      if (view.holds(body->getBody())) continue;  // an instance: this view has the pattern's closures
      const std::vector<const clang::FunctionDecl*> inner = bodies_run_elsewhere(FunctionView(body));
      found.insert(found.end(), inner.begin(), inner.end());
    }
  }
  return found;
}

void ContentClosures::made(const clang::LambdaExpr* lambda) {
  if (is_only_called(view_, lambda)) return;
  const bool is_with_messages = is_given_with_messages(view_, lambda);
  for (const clang::FunctionDecl* body : bodies_of(lambda)) {
    if (!is_with_messages && !only_deletes({nullptr, body})) any_given_to(body, log_);
    run(body, false, {});
  }
}

/// Whether it is the call operator of one of this function's closures, or an instance of that.
bool ContentClosures::is_own_closure(const clang::CXXMethodDecl* function) const {
  return llvm::any_of(view_.statements(), [&](const clang::Stmt* stmt) {
    const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt);
    return lambda &&
           lambda->getLambdaClass()->getCanonicalDecl() == function->getParent()->getCanonicalDecl();
  });
}

bool ContentClosures::called(const clang::CallExpr* call) {
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(call->getDirectCallee());
  if (!method || !method->getParent()->isLambda() || !llvm::isa<clang::CXXOperatorCallExpr>(call))
    return false;
  if (is_own_closure(method))
    run(method, true, llvm::ArrayRef<const clang::Expr*>(call->getArgs(), call->getNumArgs()).drop_front());
  else
    log_.step(UnknownCall{});  // one that the function was given
  return true;
}

/// The body is a closure's, or an instance of it, which is a function of its own to its reader.
void ContentClosures::run(const clang::FunctionDecl* body, bool once,
                          llvm::ArrayRef<const clang::Expr*> arguments) {
  ClosureRun run{body, once, {}};
  for (unsigned i = 0; i < body->getNumParams() && i < arguments.size(); ++i) {
    const clang::ParmVarDecl* const parameter = body->getParamDecl(i);
    const clang::QualType type = parameter->getType();  // a message by value: the argument makes it
    if (!is_name_of_message(type) && !is_name_of_array(type) && !is_stock_or_twin(type)) continue;
    log_.any(arguments[i]);
    if (MessagePart part = parts_.part_of(arguments[i]); !part.empty())
      run.given.emplace_back(body->isTemplateInstantiation() ? parameter_root(usr_of(pattern_of(body)), i)
                                                             : parts_.root_of(parameter),
                             std::move(part));
  }
  log_.step(std::move(run));
}

void ContentClosures::given_to(const clang::CallExpr* call) {
  const std::vector<const clang::Expr*> sources = message_sources(call);
  for (const clang::Expr* argument : call->arguments()) {
    const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(argument->IgnoreUnlessSpelledInSource());
    if (!lambda) continue;
    for (const clang::FunctionDecl* body : bodies_of(lambda))
      for (const clang::Expr* source : sources)
        run(body, false, std::vector<const clang::Expr*>(body->getNumParams(), source));
  }
}

std::vector<MessagePart> own_roots(const MessageParts& parts, const clang::FunctionDecl* body) {
  VariableFinder finder;
  for (clang::ParmVarDecl* parameter : body->parameters()) finder.TraverseDecl(parameter);
  finder.TraverseStmt(body->getBody());
  std::vector<MessagePart> roots;
  for (const clang::VarDecl* variable : finder.found) roots.push_back(parts.root_of(variable));
  return roots;
}

}  // namespace tzc::rewriter
