// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/held_locks.h"

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/lock_names.h"
#include "model/facts.h"
#include "parse/names.h"

namespace tzc::rewriter {
namespace {

using Names = std::set<std::string>;

llvm::StringRef name_of(const clang::CXXRecordDecl* record) {
  return record && record->getIdentifier() ? record->getName() : llvm::StringRef();
}

/// Of a mutex that locks, or of a pointer to one.
bool is_mutex(clang::QualType type) {
  type = type.getNonReferenceType();
  if (type->isPointerType()) type = type->getPointeeType();
  const llvm::StringRef name = name_of(type->getAsCXXRecordDecl());
  return (name.contains_insensitive("mutex") || name.contains_insensitive("spinlock")) &&
         !name.contains_insensitive("null") && !name.contains_insensitive("dummy");
}

std::string inside(const std::string& object, const clang::Decl* part) {
  return object.empty() ? object : object + "/" + usr_of(part);
}

/// Another variable may refer to the same object, or it to another one each time.
bool is_other_name(const clang::VarDecl* variable) {
  const clang::QualType type = variable->getType();
  return !variable->hasGlobalStorage() && (type->isReferenceType() || type->isPointerType());
}

/// mutex_, map.mutex_, *mutex_pointer_, grid->getMutex(); empty: one that has no name of its own.
std::string mutex_name(const clang::Expr* expr) {
  expr = expr->IgnoreParenImpCasts();
  if (llvm::isa<clang::CXXThisExpr>(expr)) return "this";
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr)) return mutex_name(op->getSubExpr());
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr))
    return op->getNumArgs() == 1 ? mutex_name(op->getArg(0)) : std::string();
  if (const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(expr)) {
    const bool is_plain = call->getNumArgs() == 0 && call->getMethodDecl();
    return is_plain ? inside(mutex_name(call->getImplicitObjectArgument()), call->getMethodDecl())
                    : std::string();
  }
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr);
  if (member && llvm::isa<clang::FieldDecl>(member->getMemberDecl()))
    return inside(mutex_name(member->getBase()), member->getMemberDecl());
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr);
  const clang::ValueDecl* named = member      ? member->getMemberDecl()
                                  : reference ? reference->getDecl()
                                              : nullptr;
  const auto* variable = llvm::dyn_cast_or_null<clang::VarDecl>(named);
  if (!variable || is_other_name(variable)) return {};
  return (variable->hasGlobalStorage() ? "" : local_lock) + usr_of(variable);
}

/// The object that the variable is made as, without the nodes that C++14 puts around it.
const clang::CXXConstructExpr* construction_of(const clang::VarDecl* variable) {
  const clang::Expr* made = variable->getInit();
  while (made) {
    made = made->IgnoreParenImpCasts();
    if (const auto* cast = llvm::dyn_cast<clang::CXXFunctionalCastExpr>(made))
      made = cast->getSubExpr();
    else if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(made))
      made = bound->getSubExpr();
    else if (const auto* kept = llvm::dyn_cast<clang::MaterializeTemporaryExpr>(made))
      made = kept->getSubExpr();
    else if (const auto* whole = llvm::dyn_cast<clang::ExprWithCleanups>(made))
      made = whole->getSubExpr();
    else
      break;
  }
  const auto* construct = llvm::dyn_cast_or_null<clang::CXXConstructExpr>(made);
  if (!construct || !construct->isElidable()) return construct;
  const auto* temporary = construct->getNumArgs() == 0 ? nullptr : construct->getArg(0);
  if (!temporary) return construct;
  return llvm::dyn_cast<clang::CXXConstructExpr>(temporary->IgnoreUnlessSpelledInSource());
}

/// What an object locks as long as it lives: none when it may have been told not to, or to give up.
Names locked_by(const clang::VarDecl* variable) {
  const clang::CXXRecordDecl* record = variable->getType()->getAsCXXRecordDecl();
  if (variable->isStaticLocal() || !names_exclusive_lock(name_of(record))) return {};
  const clang::CXXConstructExpr* made = construction_of(variable);
  if (!made || made->getConstructor()->isCopyOrMoveConstructor()) return {};
  Names mutexes;
  for (const clang::Expr* argument : made->arguments()) {
    if (name_of(argument->getType().getNonReferenceType()->getAsCXXRecordDecl()) == "adopt_lock_t") continue;
    const std::string mutex = is_mutex(argument->getType()) ? mutex_name(argument) : std::string();
    if (mutex.empty() && !llvm::isa<clang::CXXDefaultArgExpr>(argument)) return {};
    mutexes.insert(mutex);
  }
  mutexes.erase("");
  return mutexes;
}

llvm::StringRef callee_of(const clang::CallExpr* call) {
  const clang::FunctionDecl* callee = call->getDirectCallee();
  return callee && callee->getIdentifier() ? callee->getName() : llvm::StringRef();
}

/// mutex_.lock(), pthread_mutex_lock(&mutex_), and their opposites.
std::string mutex_of(const clang::CallExpr* call) {
  if (const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call)) {
    const clang::Expr* object = member->getImplicitObjectArgument();
    return is_mutex(object->getType()) ? mutex_name(object) : std::string();
  }
  return call->getNumArgs() == 1 ? mutex_name(call->getArg(0)) : std::string();
}

/// std::condition_variable::wait, wait_for, and boost's.
bool waits(const clang::FunctionDecl* callee) {
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(callee);
  return method && name_of(method->getParent()).starts_with("condition_variable") &&
         method->getIdentifier() && method->getName().contains("wait");
}

std::string locked_at(const clang::Stmt* statement) {
  const auto* expr = llvm::dyn_cast<clang::Expr>(statement);
  const auto* call = expr ? llvm::dyn_cast<clang::CallExpr>(expr->IgnoreUnlessSpelledInSource()) : nullptr;
  const llvm::StringRef callee = call ? callee_of(call) : llvm::StringRef();
  return callee == "lock" || callee == "pthread_mutex_lock" ? mutex_of(call) : std::string();
}

}  // namespace

HeldLocks::HeldLocks(const ThreadCode& code, const FunctionView& view) : code_(code), view_(view) {
  for (const clang::Stmt* stmt : view.statements())
    if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt); call && callee_of(call).contains("unlock"))
      unlocks_.push_back(call);
}

std::vector<HeldLocks::Taking> HeldLocks::takings_of(const clang::Stmt* statement) const {
  std::vector<Taking> takings;
  if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(statement)) {
    for (const clang::Decl* decl : declaration->decls())
      if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl))
        takings.push_back({statement, variable, locked_by(variable)});
  } else if (std::string mutex = locked_at(statement); !mutex.empty()) {
    takings.push_back({statement, nullptr, {std::move(mutex)}});
  }
  return takings;
}

/// In the order of the source, or in the next pass of a loop that the lock outlives. What is in a closure happens when that is called.
bool HeldLocks::comes_between(const clang::Stmt* taking, const clang::Stmt* release,
                              const clang::Stmt* use) const {
  const FunctionView::Span from = view_.span(taking);
  const FunctionView::Span at = view_.span(release);
  const FunctionView::Span here = view_.span(use);
  const clang::LambdaExpr* closure = view_.lambda_around(taking);
  if (view_.lambda_around(release) != closure) return true;
  if (view_.lambda_around(use) != closure) return at.enter > from.exit;
  const bool again = llvm::any_of(view_.repeated(), [&](const FunctionView::Span& loop) {
    return loop.enter > from.exit && loop.contains(at) && loop.contains(here);
  });
  return again || (at.enter > from.exit && at.enter < here.enter);
}

/// Anything but ready_.wait(lock), which has the lock again when it returns.
bool HeldLocks::gives_back(const clang::DeclRefExpr* guard) const {
  const clang::Stmt* around = view_.parent(guard);
  while (is_wrapping(around)) around = view_.parent(around);
  if (const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(around))
    return member->getMemberDecl()->getNameAsString() != "owns_lock";
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(around);
  return !call || !waits(call->getDirectCallee());
}

bool HeldLocks::is_given_back(const Taking& taking, const clang::Stmt* use) const {
  if (taking.guard)
    return llvm::any_of(view_.uses(taking.guard), [&](const clang::DeclRefExpr* name) {
      return gives_back(name) && comes_between(taking.at, name, use);
    });
  return llvm::any_of(unlocks_, [&](const clang::CallExpr* unlock) {
    const std::string mutex = mutex_of(unlock);
    return (mutex.empty() || taking.mutexes.count(mutex) != 0) && comes_between(taking.at, unlock, use);
  });
}

Names HeldLocks::at(const clang::Stmt* stmt) const {
  Names held;
  if (view_.jumps()) return held;
  const clang::LambdaExpr* closure = code_.closure_around(stmt);
  const clang::Stmt* inner = stmt;
  for (const clang::Stmt* around = view_.parent(stmt); around && around != closure;
       inner = around, around = view_.parent(around)) {
    const auto* block = llvm::dyn_cast<clang::CompoundStmt>(around);
    if (!block || llvm::isa_and_nonnull<clang::SwitchStmt>(view_.parent(block)))
      continue;  // a case may begin later
    for (const clang::Stmt* before : block->body()) {
      if (before == inner) break;
      for (const Taking& taking : takings_of(before))
        if (!taking.mutexes.empty() && !is_given_back(taking, stmt))
          held.insert(taking.mutexes.begin(), taking.mutexes.end());
    }
  }
  return held;
}

}  // namespace tzc::rewriter
