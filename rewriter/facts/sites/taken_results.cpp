// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/taken_results.h"

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/calls.h"

namespace tzc::rewriter {
namespace {

/// What a copy is made of; null: it is none.
const clang::Expr* copied(const clang::Expr* initializer) {
  const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(initializer->IgnoreImplicit());
  return construct && construct->getConstructor()->isCopyConstructor() && construct->getNumArgs() > 0
             ? construct->getArg(0)->IgnoreImpCasts()
             : nullptr;
}

}  // namespace

std::vector<Change> move_out_of_result(const Unit& unit, const clang::Expr* initializer) {
  const clang::Expr* message = copied(initializer);
  const clang::Expr* pointer = message ? pointer_followed(message->IgnoreParens()) : nullptr;
  const auto* call =
      pointer ? llvm::dyn_cast<clang::CallExpr>(pointer->IgnoreParens()->IgnoreImplicit()) : nullptr;
  const auto where =
      call && builds_message(unit, call) ? unit.source.place(message->getSourceRange()) : std::nullopt;
  if (!where) return {};
  const Place begin{where->file, where->begin, where->begin, where->line, where->column};
  const Place end{where->file, where->end, where->end, where->line, where->column};
  return {{begin, "std::move(", "message-type", {}}, {end, ")", "message-type", {}}};
}

}  // namespace tzc::rewriter
