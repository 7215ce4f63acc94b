// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/thread_starts.h"

#include <set>

#include "facts/escape/threads.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/known_functions.h"

namespace tzc::rewriter {
namespace {

/// boost::bind(&Node::work, this), boost::function<void()>(...): what is in it is called when it is.
bool only_wraps(const clang::FunctionDecl* function) {
  const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(function);
  if (constructor && constructor->getParent()->isLambda()) return true;
  const std::string name =
      constructor ? qualified_name_of(constructor->getParent()) : qualified_name_of(function);
  static const std::set<std::string> wrappers = {
      "boost::bind", "std::bind", "boost::function", "std::function", "boost::ref",
      "std::ref",    "std::move", "std::mem_fn",     "boost::mem_fn", "boost::protect"};
  return wrappers.count(name) != 0 || llvm::StringRef(name).starts_with("boost::_bi::");
}

/// std::thread(...), std::make_unique<std::thread>(...)
bool starts_thread(const clang::FunctionDecl* function) {
  const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(function);
  if (constructor) return makes_thread(qualified_name_of(constructor->getParent()));
  const clang::TemplateArgumentList* arguments = function->getTemplateSpecializationArgs();
  const bool makes = arguments && arguments->size() > 0 && function->getIdentifier() &&
                     function->getName().starts_with("make_") &&
                     arguments->get(0).getKind() == clang::TemplateArgument::Type;
  const clang::CXXRecordDecl* made = makes ? arguments->get(0).getAsType()->getAsCXXRecordDecl() : nullptr;
  return makes_thread(made ? qualified_name_of(made) : qualified_name_of(function));
}

const clang::FunctionDecl* called_by(const clang::Expr* expr) {
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expr)) return made->getConstructor();
  const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
  return call ? call->getDirectCallee() : nullptr;
}

/// Whether what stands here happens once for each call of its function.
bool is_in_loop(const Unit& unit, const clang::DynTypedNode& mention) {
  for (auto node = written_parent(unit.ast(), mention); node; node = written_parent(unit.ast(), *node)) {
    if (node->get<clang::FunctionDecl>() || node->get<clang::LambdaExpr>()) return false;
    const auto* stmt = node->get<clang::Stmt>();
    if (llvm::isa_and_nonnull<clang::ForStmt, clang::WhileStmt, clang::DoStmt, clang::CXXForRangeStmt,
                              clang::LabelStmt>(stmt))
      return true;
  }
  return false;
}

/// Constructors run once for each object, and main and onInit (of a nodelet) once.
bool is_in_what_runs_once(const Unit& unit, const clang::DynTypedNode& mention) {
  const auto* expr = mention.get<clang::Stmt>();
  const clang::FunctionDecl* function = expr ? enclosing_function(unit.ast(), *expr) : nullptr;
  if (!function) return false;
  return llvm::isa<clang::CXXConstructorDecl>(function) || function->isMain() ||
         function->getNameAsString() == "onInit";
}

/// sub_, options_.sub: it lasts, and has one value at a time.
bool is_one_that_lasts(const clang::Expr* target) {
  target = target->IgnoreParenImpCasts();
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(target)) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(name->getDecl());
    return variable && variable->hasGlobalStorage();
  }
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(target);
  return member && (llvm::isa<clang::CXXThisExpr>(member->getBase()->IgnoreParenImpCasts()) ||
                    (!member->isArrow() && is_one_that_lasts(member->getBase())));
}

/// sync_->registerCallback(...): a filter calls its callbacks one after the other.
bool is_given_to_one_filter(const clang::Expr* expr) {
  static const std::set<std::string> names = {"registerCallback", "setCallback"};
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(expr);
  const clang::CXXMethodDecl* method = call ? call->getMethodDecl() : nullptr;
  if (!method || names.count(method->getNameAsString()) == 0) return false;
  const clang::Expr* object = call->getImplicitObjectArgument()->IgnoreParenImpCasts();
  const auto* arrow = llvm::dyn_cast<clang::CXXOperatorCallExpr>(object);
  return is_one_that_lasts(arrow ? arrow->getArg(0) : object);
}

/// sub_ = nh.subscribe(...): the next call of its function ends what this one began.
bool ends_the_one_before(const Unit& unit, const clang::Expr* call) {
  if (is_given_to_one_filter(call)) return true;
  const auto begin = clang::DynTypedNode::create(*call);
  for (auto node = written_parent(unit.ast(), begin); node; node = written_parent(unit.ast(), *node)) {
    if (const auto* variable = node->get<clang::VarDecl>()) return variable->hasGlobalStorage();
    const auto* expr = node->get<clang::Expr>();
    const auto* assigned = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(expr);
    if (assigned) return assigned->getOperator() == clang::OO_Equal && is_one_that_lasts(assigned->getArg(0));
    if (!expr || !(is_wrapping(expr) || llvm::isa<clang::CXXConstructExpr>(expr))) return false;
  }
  return false;
}

/// What gets a function or closure, bound or wrapped or as it is.
struct Runner {
  bool has_one_thread = false;
  bool may_be_thread = true;
};

Runner runner_of(const Unit& unit, const clang::Expr* handed) {
  const auto mention = clang::DynTypedNode::create(*handed);
  for (auto node = written_parent(unit.ast(), mention); node; node = written_parent(unit.ast(), *node)) {
    const auto* expr = node->get<clang::Expr>();
    if (!expr) break;
    if (is_wrapping(expr) || llvm::isa<clang::UnaryOperator, clang::ExplicitCastExpr>(expr)) continue;
    const clang::FunctionDecl* function = called_by(expr);
    if (!function) break;
    const bool runs_once = !is_in_loop(unit, mention) && is_in_what_runs_once(unit, mention);
    if (runs_one_at_a_time(qualified_name_of(function)))
      return {runs_once || (!is_in_loop(unit, mention) && ends_the_one_before(unit, expr)), false};
    if (starts_thread(function)) return {runs_once, true};
    if (!only_wraps(function)) break;
  }
  return {};
}

}  // namespace

void ThreadStarts::note(const clang::FunctionDecl* function, const clang::DeclRefExpr* mention) {
  const std::string usr = usr_of(pattern_of(function));
  found_.addressed.insert(usr);
  add(usr, mention);
}

void ThreadStarts::note(const clang::LambdaExpr* lambda) {
  add(closure_name(unit_, lambda), lambda);
}

void ThreadStarts::add(const std::string& code, const clang::Expr* mention) {
  CodeStarts& starts = found_.starts[code];
  const Runner runner = runner_of(unit_, mention);
  starts.by_thread |= runner.may_be_thread;
  if (runner.has_one_thread)
    starts.by_one.insert(place_name(unit_, mention));
  else
    starts.by_any = true;
}

}  // namespace tzc::rewriter
