// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include "facts/flow/entity_table.h"
#include "facts/syntax/bound_calls.h"

namespace tzc::rewriter {

/// Functions of the package that other code calls: their parameters and results keep their types. Deleters do not (deleters.h).
class CallbackPins {
 public:
  CallbackPins(const Unit& unit, EntityTable& entities) : unit_(unit), entities_(entities) {}

  /// A function whose address is taken is a callback. False: the name only calls it.
  bool check_address_taken(const clang::FunctionDecl* function, const clang::DeclRefExpr* reference);
  /// A lambda that is not kept in a variable is a callback.
  void check_lambda(const clang::LambdaExpr* lambda);

 private:
  bool is_callee(const clang::DeclRefExpr* reference) const;
  bool is_kept(const clang::LambdaExpr* lambda) const;
  std::optional<BoundCall> binding(const clang::DeclRefExpr* reference) const;
  void pin(const clang::ParmVarDecl* parameter, const std::string& name, bool subscribes);

  const Unit& unit_;
  EntityTable& entities_;
};

}  // namespace tzc::rewriter
