// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "facts/flow/value_flow.h"

namespace tzc::rewriter {

/// Filter objects that subscribe: message_filters::Subscriber<M> and its likes.
class FilterCollector {
 public:
  FilterCollector(const Unit& unit, EntityTable& entities, ValueFlow& flow)
      : unit_(unit), entities_(entities), flow_(flow) {}

  /// message_filters::Subscriber and its like
  bool is_filter(const clang::CXXRecordDecl* record) const;
  /// filter.subscribe(nh, "topic", 1)
  std::optional<Subscribe> of_call(const clang::CXXMemberCallExpr* call);
  /// Subscriber<M> filter(nh, "topic", 1)
  std::optional<Subscribe> of_construction(const clang::CXXConstructExpr* construct);
  /// make_shared<Subscriber<M>>(nh, "topic", 1)
  std::optional<Subscribe> of_made(const clang::CallExpr* call, const EntityId& filter);
  /// tzc::message_filters::subscribe(filter, nh, "topic", 1): an earlier run wrote it.
  std::optional<Subscribe> of_attached(const clang::CallExpr* call);
  /// subscribers.emplace_back(nh, "topic", 1)
  std::optional<Subscribe> of_emplaced(const clang::CXXMemberCallExpr* call);
  /// What the callbacks that registerCallback() is given do with their messages.
  void add_callbacks(const clang::CXXMemberCallExpr* call,
                     std::map<FilterCallback, FilterCallbackUse>& callbacks) const;

 private:
  struct Construction {
    const clang::Expr* expr;
    const clang::CXXRecordDecl* record;  ///< the filter's class
    llvm::ArrayRef<const clang::Expr*> arguments;
    bool is_attached = false;  ///< by an earlier run
    std::vector<Change> changes_if_kept{};
  };
  Subscribe site_of(const Construction& construction, const EntityId& filter) const;
  void subscribe_by_method(const EntityId& filter, const clang::CallExpr* call);
  std::vector<Change> changes_if_kept(const clang::CXXMemberCallExpr* call) const;
  EntityId filter_of(const clang::Expr* object);
  void note_callback(std::map<FilterCallback, FilterCallbackUse>& callbacks,
                     const clang::FunctionDecl* function, FilterCallback where) const;
  std::string scope_of(const clang::Expr* expr) const;
  EntityId constructed(const clang::CXXConstructExpr* construct);

  const Unit& unit_;
  EntityTable& entities_;
  ValueFlow& flow_;
};

}  // namespace tzc::rewriter
