// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/StmtCXX.h>
#include <clang/Analysis/CFG.h>

#include <unordered_map>

namespace tzc::rewriter {

/// The try blocks of one body. Clang's graph leads to their handlers from `throw` alone, while any statement that calls something may
/// throw.
class Handlers {
 public:
  Handlers(const clang::CFG& cfg, const clang::Stmt* body);

  /// The block that leads to the handlers of the innermost try block around the element; null: it lies in none.
  const clang::CFGBlock* around(const clang::CFGElement& element) const;

 private:
  void enter(const clang::Stmt* stmt, const clang::CFGBlock* handlers);

  std::unordered_map<const clang::Stmt*, const clang::CFGBlock*> of_try_;  ///< by try statement
  std::unordered_map<const clang::Stmt*, const clang::CFGBlock*> around_;  ///< what lies in a try block
};

}  // namespace tzc::rewriter
