// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "facts/escape/threads.h"
#include "facts/syntax/function_view.h"

namespace tzc::rewriter {

/// Which locks a thread surely has at a place of a function, and no other thread with it: those that the blocks around the place have taken
/// in front of it, and that nothing may have given back on the way.
class HeldLocks {
 public:
  HeldLocks(const ThreadCode& code, const FunctionView& view);

  /// The mutexes' names: the same in every unit and function, but for local variables (local_lock).
  std::set<std::string> at(const clang::Stmt* stmt) const;

 private:
  struct Taking {
    const clang::Stmt* at;
    const clang::VarDecl* guard;  ///< null: mutex.lock()
    std::set<std::string> mutexes;
  };
  std::vector<Taking> takings_of(const clang::Stmt* statement) const;
  bool is_given_back(const Taking& taking, const clang::Stmt* use) const;
  bool gives_back(const clang::DeclRefExpr* guard) const;
  bool comes_between(const clang::Stmt* taking, const clang::Stmt* release, const clang::Stmt* use) const;

  const ThreadCode& code_;
  const FunctionView& view_;
  std::vector<const clang::CallExpr*> unlocks_;
};

}  // namespace tzc::rewriter
