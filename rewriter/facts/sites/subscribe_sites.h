// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include "facts/flow/entity_table.h"

namespace tzc::rewriter {

/// Calls that subscribe. Adds the parameters of their callbacks to the table.
class SubscribeCollector {
 public:
  SubscribeCollector(const Unit& unit, EntityTable& entities) : unit_(unit), entities_(entities) {}

  /// nh.subscribe(...), as `rule` matches it.
  Subscribe of_call(const clang::CXXMemberCallExpr* call, const MethodCall& rule);
  /// What `rule` wrote in an earlier run: tzc::subscribe(nh, ...).
  Subscribe of_ported_call(const clang::CallExpr* call, const MethodCall& rule);

 private:
  Subscribe site_at(const clang::CallExpr* call, const MethodCall& rule) const;
  void add_options(Subscribe& site, const clang::Expr* options);
  void add_callbacks(Subscribe& site, const clang::CallExpr* call);

  const Unit& unit_;
  EntityTable& entities_;
};

}  // namespace tzc::rewriter
