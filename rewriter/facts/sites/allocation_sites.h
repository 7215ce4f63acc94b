// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <optional>
#include <vector>

#include "facts/flow/value_flow.h"
#include "facts/sites/hoisting.h"

namespace tzc::rewriter {

/// An allocation site before it is known which publishers are available there.
struct AllocationDraft {
  AllocationSite site;
  const clang::FunctionDecl* function;       ///< around it
  const clang::VarDecl* variable = nullptr;  ///< that is declared with the message; null: none
  bool is_of_template = false;               ///< whose instances know better how the message starts
};

/// The site of an entity, with its place and function.
AllocationDraft draft_at(const Unit& unit, const EntityTable& entities, const EntityId& id,
                         const clang::Stmt& where);

/// Finds where messages are made and allocate can be called. Messages that are members, globals or static locals are not among them:
/// allocate would write where the source perhaps only reads, in several threads at once. The first publish binds them.
class AllocationCollector {
 public:
  AllocationCollector(const Unit& unit, EntityTable& entities, ValueFlow& flow)
      : unit_(unit), entities_(entities), flow_(flow) {}

  /// Image image; also Image images[2], of which each element has such a site (few_messages_in).
  std::optional<AllocationDraft> of_declaration(const clang::VarDecl* variable);
  /// A new object: new M, make_shared<M>(), M(), and where its value ends.
  std::optional<AllocationDraft> of_object(const clang::Expr* expr, const EntityId& id, const FlowEnd& end);
  /// A library call that makes a message: toImageMsg().
  std::optional<AllocationDraft> of_adapter(const clang::CXXMemberCallExpr* call, const EntityId& id,
                                            const MethodCall& rule);
  /// Frame frame; and the message frame.image, which `part` names.
  std::optional<AllocationDraft> of_part(const clang::Expr* part, const EntityId& id);

 private:
  void place_behind(InsertedAllocation& how, const clang::Stmt* statement) const;
  bool is_fresh(const FlowSources& sources) const;
  bool takes_over(const clang::Expr* expr) const;
  bool is_result(const FlowSources& sources) const;

  const Unit& unit_;
  EntityTable& entities_;
  ValueFlow& flow_;
};

/// The site with the publishers of its function that are available there. It may move after a publisher that is declared later in
/// the same block, while nothing has touched the message's arrays.
AllocationSite connected(const Unit& unit, AllocationDraft draft,
                         const std::vector<PublisherMention>& mentions);

}  // namespace tzc::rewriter
