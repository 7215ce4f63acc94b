// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/lock_names.h"

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/window_callbacks.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

bool names_lock(llvm::StringRef name) {
  if (name.ends_with("join") || name.starts_with("wait") || name.contains("atomic") || name == "acquire")
    return true;
  return name.contains_insensitive("lock") && !name.contains_insensitive("clock") &&
         !name.contains_insensitive("block") && !name.contains_insensitive("unlock");
}

/// Of std::atomic<T>, boost::atomic_flag, std::future<T>: what one thread leaves there another one takes.
bool takes_over(const clang::FunctionDecl* callee) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee);
  if (!method || !method->getParent()->getIdentifier()) return false;
  const llvm::StringRef record = method->getParent()->getName();
  return record.contains("atomic") || record.contains("future");
}

/// Of a function or class by which threads meet.
bool names_meeting(llvm::StringRef name) {
  static constexpr llvm::StringRef parts[] = {
      "thread",    "async", "mutex",  "semaphore", "sem_",    "signal", "notify", "future", "promise",
      "condition", "event", "latch",  "queue",     "barrier", "fence",  "post",   "spawn",  "task",
      "emit",      "sync",  "unlock", "parallel",  "start",   "fork",   "detach", "stop"};
  return llvm::any_of(parts, [&](llvm::StringRef part) { return name.contains_insensitive(part); });
}

/// Which no threads meet in, whatever its name is.
bool is_plain_queue(const clang::CXXRecordDecl* record) {
  return record->isInStdNamespace() &&
         (record->getName() == "queue" || record->getName() == "priority_queue");
}

bool is_between_processes(const clang::FunctionDecl* function) {
  static constexpr llvm::StringRef names[] = {"read", "write",    "send",    "sendto", "sendmsg", "recv",
                                              "poll", "recvfrom", "recvmsg", "select", "kill",    "raise"};
  return function->isExternC() && llvm::is_contained(names, function->getName());
}

class LockFinder : public AstVisitor {
 public:
  bool found = false;
  bool VisitStmt(clang::Stmt* stmt) override {
    found = found || takes_lock(stmt);
    return !found;
  }
};

}  // namespace

bool takes_lock(const clang::Stmt* stmt) {
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt))
    return names_lock(made->getConstructor()->getParent()->getName());
  const auto* expr = llvm::dyn_cast<clang::Expr>(stmt);
  // The literal of a static_assert has no type.
  if (expr && !expr->getType().isNull() && expr->getType().isVolatileQualified()) return true;
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  const clang::FunctionDecl* callee = call ? call->getDirectCallee() : nullptr;
  return callee && !runs_window_callbacks(call) &&
         (takes_over(callee) || (callee->getIdentifier() && names_lock(callee->getName())));
}

bool may_synchronize(const clang::Stmt* stmt) {
  if (takes_lock(stmt)) return true;
  const clang::FunctionDecl* callee = nullptr;
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt)) callee = made->getConstructor();
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt)) callee = call->getDirectCallee();
  if (!callee) return llvm::isa<clang::CallExpr>(stmt);
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee);
  if (method && is_plain_queue(method->getParent())) return false;
  const bool has_name = callee->getIdentifier() != nullptr;
  return (has_name && (names_meeting(callee->getName()) || is_between_processes(callee))) ||
         (method && method->getParent()->getIdentifier() && names_meeting(method->getParent()->getName()));
}

bool takes_locks(const clang::FunctionDecl* definition) {
  LockFinder locks;
  locks.TraverseStmt(definition->getBody());
  return locks.found;
}

bool names_exclusive_lock(llvm::StringRef name) {
  return name.contains_insensitive("lock") && names_lock(name) && !name.contains_insensitive("shared") &&
         !name.contains_insensitive("upgrade") && !name.contains_insensitive("read");
}

}  // namespace tzc::rewriter
