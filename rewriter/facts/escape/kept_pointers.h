// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>

#include "facts/escape/publish_events.h"
#include "facts/escape/threads.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// What a function does with elements through a variable that it keeps a pointer or an iterator in:
/// `float* x = reinterpret_cast<float*>(&cloud.data[0]); *x++ = 1;`
class KeptPointers {
 public:
  using Kinds = std::set<ElementUse::Kind>;

  KeptPointers(const SeenFunction& seen, const ThreadCode& code)
      : view_(seen.view), events_(seen.events), code_(code) {}

  /// `pointer` leads to elements. Who writes through it writes. He walks, too, unless he does nothing but write, and lets no other thread
  /// come between the declaration and the end of the variable's life: one that publishes meanwhile would read what he writes.
  Kinds kinds_of(const clang::Expr* pointer) const;

 private:
  const clang::VarDecl* variable_of(const clang::Expr* pointer) const;
  /// What still leads to the elements, and what it stands in.
  struct Value {
    const clang::Stmt *pointer, *around;
  };
  Value value_of(const clang::DeclRefExpr* use) const;
  const clang::Stmt* element_of(const clang::DeclRefExpr* use) const;
  bool is_written(const clang::DeclRefExpr* use) const;
  bool only_steps(const clang::DeclRefExpr* use) const;
  bool stands_alone(const clang::VarDecl* variable) const;

  const FunctionView& view_;
  const std::vector<SeenEvent>& events_;
  const ThreadCode& code_;
};

/// Functions of the standard library that write where this argument points to.
bool writes_to(const std::string& function, unsigned argument);

}  // namespace tzc::rewriter
