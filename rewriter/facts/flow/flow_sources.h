// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <string>
#include <vector>

#include "facts/flow/entity_table.h"

namespace tzc::rewriter {

/// Which entities an expression's value comes from.
struct FlowSources {
  std::vector<EntityId> entities;
  bool foreign = false;  ///< also from something outside the package
};

/// Who builds a value that comes from something outside the package, as the subject of a sentence.
std::string builder_of(const clang::Expr* value);

/// Backward value flow: from an expression down to the entities that its value comes from.
class SourceFinder {
 public:
  SourceFinder(const Unit& unit, EntityTable& entities) : unit_(unit), entities_(entities) {}

  /// Makes the entities known to the table.
  FlowSources of(const clang::Expr* expr);

 private:
  FlowSources of_name(const clang::DeclRefExpr* name);
  FlowSources of_member(const clang::MemberExpr* member);
  FlowSources of_method(const clang::CXXMemberCallExpr* call);
  FlowSources of_call(const clang::CallExpr* call);
  FlowSources of_construction(const clang::CXXConstructExpr* construct);
  FlowSources of_arguments(llvm::ArrayRef<const clang::Expr*> arguments);
  FlowSources of_parts(const clang::InitListExpr* list);
  FlowSources of_cast(const clang::ExplicitCastExpr* cast);
  FlowSources of_choice(const clang::ConditionalOperator* choice);
  const clang::Expr* operand_of(const clang::Expr* expr) const;
  bool carries(clang::QualType type) const { return carried_by(type, unit_.rules).has_value(); }

  const Unit& unit_;
  EntityTable& entities_;
};

}  // namespace tzc::rewriter
