// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "facts/escape/hidden_calls.h"
#include "facts/escape/publish_events.h"
#include "facts/escape/threads.h"
#include "facts/flow/entity_table.h"
#include "facts/flow/value_flow.h"
#include "facts/sites/advertise_sites.h"
#include "facts/sites/allocation_sites.h"
#include "facts/sites/filter_sites.h"
#include "facts/sites/hoisting.h"
#include "facts/sites/subscribe_sites.h"
#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// Passes the nodes of one unit to the collectors of facts and keeps what these return.
class Collectors {
 public:
  explicit Collectors(const Unit& unit)
      : unit_(unit),
        entities_(unit),
        flow_(unit, entities_),
        allocations_(unit, entities_, flow_),
        filters_(unit, entities_, flow_),
        advertises_(unit, entities_),
        subscribes_(unit, entities_),
        hidden_(unit) {}

  EntityTable& entities() { return entities_; }
  ValueFlow& flow() { return flow_; }

  void declaration(const clang::VarDecl* variable);
  void function(const clang::FunctionDecl* function);
  void bases(const clang::CXXRecordDecl* record);
  /// A mention of a variable or member.
  void name(const clang::Expr* expr, const clang::ValueDecl* decl);
  void object(const clang::Expr* expr, const clang::TypeSourceInfo* type);
  void construction(const clang::CXXConstructExpr* construct);
  void call(const clang::CallExpr* call);
  /// Analyses the escapes in these functions. A mention of an array that this does not reach is an escape.
  void escapes(const std::vector<const clang::FunctionDecl*>& functions,
               const std::vector<const clang::MemberExpr*>& arrays);
  void contents(EscapeContext& context, const SeenFunction& seen, const ThreadCode& code);
  void early_calls(const clang::Stmt* stmt);
  Facts finish();

 private:
  void made_object(const clang::CallExpr* call);
  void member_call(const clang::CXXMemberCallExpr* call);
  void rule_call(const clang::CXXMemberCallExpr* call, const MethodCall& rule);
  void ported_call(const clang::CallExpr* call, const clang::FunctionDecl* function);
  void library_call(const clang::CallExpr* call);
  void publish(const clang::CXXMemberCallExpr* call);
  void add(std::optional<AllocationDraft> draft) {
    if (draft) drafts_.push_back(std::move(*draft));
  }

  const Unit& unit_;
  EntityTable entities_;
  ValueFlow flow_;
  AllocationCollector allocations_;
  FilterCollector filters_;
  AdvertiseCollector advertises_;
  SubscribeCollector subscribes_;
  Facts facts_;
  HiddenCode hidden_;
  std::vector<PublisherMention> publishers_;
  std::vector<AllocationDraft> drafts_;
  std::map<std::pair<std::string, std::string>, std::pair<EntityId, const clang::Expr*>>
      parts_;  // of objects that are messages, by function and text
};

}  // namespace tzc::rewriter
