// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <map>
#include <set>
#include <vector>

#include "facts/escape/shared_climb.h"

namespace tzc::rewriter {

/// Follows the image that cv_bridge::toCvShare gives, and everything that shares its elements, to what may write to
/// them: through variables, members, globals, containers, results and output parameters of the unit. Nothing but the
/// level of subscriptions depends on it: at run time a write changes private pages.
class SharedMats : private SharedElements {
 public:
  explicit SharedMats(EscapeContext& context) : context_(context) {}

  /// Of a function with a body; a lambda is part of the function around it. The view must outlive this.
  void analyse(const FunctionView& view);
  /// When all functions were analysed.
  void finish();

 private:
  struct Mention {
    const FunctionView* view;
    const clang::Expr* expr;
  };
  void hold(const clang::ValueDecl* holder) override;
  void hold_object(const clang::Expr* object) override;
  void write(const clang::Expr* at) override;
  void index(const FunctionView& view);
  void give_back(const clang::ParmVarDecl* parameter);
  const clang::ValueDecl* named_object(const clang::Expr* expr) const;

  EscapeContext& context_;
  std::vector<const FunctionView*> views_;
  std::vector<Mention> shares_;
  std::map<const clang::ValueDecl*, std::vector<Mention>> mentions_;
  std::map<const clang::ValueDecl*, std::set<EntityId>> holders_;
  std::deque<std::pair<const clang::ValueDecl*, std::set<EntityId>>> open_;
  std::set<std::pair<const clang::ParmVarDecl*, EntityId>> outputs_;
  std::set<EntityId> written_;
  std::set<EntityId> current_;  ///< the messages whose elements are followed
};

}  // namespace tzc::rewriter
