// SPDX-License-Identifier: BSD-3-Clause
#pragma once

//   expression ──sources_of──> entities that its value comes from           (flow_sources.h, downwards)
//   use of an entity ──follow──> entities, edits, obstacles, where it ended  (flow_uses.h, upwards)
//                                 └── what a call does with it: flows on, takes an edit, escapes (call_effects.h)

#include "facts/flow/flow_uses.h"
#include "facts/flow/foreign_bodies.h"
#include "facts/flow/foreign_casts.h"
#include "facts/flow/lost_const.h"

namespace tzc::rewriter {

/// Where values come from and where they go to. Writes its results into the entity table.
class ValueFlow {
 public:
  ValueFlow(const Unit& unit, EntityTable& entities)
      : unit_(unit), entities_(entities), sources_(unit, entities), bodies_(unit), uses_(unit, entities) {}

  FlowSources sources_of(const clang::Expr* expr) { return sources_.of(expr); }
  /// Those of them that are ported as something of that role. What is a part of another thing is none: it has come from elsewhere.
  FlowSources sources_of(const clang::Expr* expr, EntityRole role);
  FlowEnd follow(const clang::Expr* leaf, const EntityId& id) { return uses_.follow(leaf, id); }

  /// A variable that starts with a message, or publisher, of code outside the package.
  void check_source_of(const clang::VarDecl* variable);
  /// const_cast of a message: code that receives it may write to it.
  void check_const_cast(const clang::ExplicitCastExpr* cast);
  /// \name Other ways in which code may get a message to write to that it was given as const
  /// @{
  void check_call(const clang::CallExpr* call);
  void check_construction(const clang::CXXConstructExpr* construct);
  void check_union(const clang::MemberExpr* member);
  void check_variable_argument(const clang::VAArgExpr* argument);
  /// @}
  /// What these found, const_cast included.
  const std::vector<ConstCast>& const_casts() const { return const_casts_; }
  /// Where something else is taken for a message, const or not.
  const std::vector<ConstCast>& foreign_casts() const { return foreign_casts_; }
  /// The elements of a container become the loop's variable.
  void loop_over(const clang::CXXForRangeStmt* loop);

 private:
  void note_writable(const clang::ExplicitCastExpr* cast);
  void note_as_bytes(const clang::Expr* converted);
  template <class Call>
  void note_foreign_body(const Call* call, const clang::FunctionDecl* function);
  void note_event(const UncopiedEvent& event, clang::SourceLocation where);
  /// A message of the type, any or one of these, can be written to from here on.
  struct Writable {
    clang::QualType type;
    std::vector<EntityId> messages;
    std::string reason;
  };
  void add_writable(Writable writable, clang::SourceLocation where);
  void add_foreign(const std::optional<ForeignCast>& cast, clang::SourceLocation where);

  const Unit& unit_;
  EntityTable& entities_;
  SourceFinder sources_;
  ForeignBodies bodies_;
  std::vector<ConstCast> const_casts_, foreign_casts_;
  UseFollower uses_;
};

}  // namespace tzc::rewriter
