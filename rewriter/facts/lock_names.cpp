// SPDX-License-Identifier: BSD-3-Clause
#include "facts/lock_names.h"

#include <clang/AST/ExprCXX.h>

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

/// lock_guard, unique_lock, mutex_.lock(); several threads may have a shared_lock.
bool names_exclusive_lock(llvm::StringRef name) {
  return name.contains_insensitive("lock") && names_lock(name) && !name.contains_insensitive("shared") &&
         !name.contains_insensitive("upgrade") && !name.contains_insensitive("read");
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
  return callee && (takes_over(callee) || (callee->getIdentifier() && names_lock(callee->getName())));
}

bool takes_locks(const clang::FunctionDecl* definition) {
  LockFinder locks;
  locks.TraverseStmt(definition->getBody());
  return locks.found;
}

bool takes_exclusive_lock(const clang::Stmt* stmt) {
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt))
    return names_exclusive_lock(made->getConstructor()->getParent()->getName());
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  const clang::FunctionDecl* callee = call ? call->getDirectCallee() : nullptr;
  return callee && callee->getIdentifier() && names_exclusive_lock(callee->getName());
}

}  // namespace tzc::rewriter
