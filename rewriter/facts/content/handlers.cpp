// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/handlers.h"

namespace tzc::rewriter {

Handlers::Handlers(const clang::CFG& cfg, const clang::Stmt* body) {
  for (const clang::CFGBlock* block : cfg)
    if (const auto* tried = llvm::dyn_cast_or_null<clang::CXXTryStmt>(block->getTerminatorStmt()))
      of_try_.emplace(tried, block);
  if (!of_try_.empty()) enter(body, nullptr);
}

const clang::CFGBlock* Handlers::around(const clang::CFGElement& element) const {
  if (of_try_.empty()) return nullptr;
  const auto stmt = element.getAs<clang::CFGStmt>();
  const auto found = stmt ? around_.find(stmt->getStmt()) : around_.end();
  return found == around_.end() ? nullptr : found->second;
}

/// What a handler throws goes to the try block around its own.
void Handlers::enter(const clang::Stmt* stmt, const clang::CFGBlock* handlers) {
  if (!stmt) return;
  if (handlers) around_.emplace(stmt, handlers);
  const auto* tried = llvm::dyn_cast<clang::CXXTryStmt>(stmt);
  const auto inner = tried ? of_try_.find(tried) : of_try_.end();
  for (const clang::Stmt* child : stmt->children()) {
    const bool is_tried = inner != of_try_.end() && child == tried->getTryBlock();
    enter(child, is_tried ? inner->second : handlers);
  }
}

}  // namespace tzc::rewriter
