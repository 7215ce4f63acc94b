// SPDX-License-Identifier: BSD-3-Clause
#include "facts/value_flow.h"

#include <clang/AST/StmtCXX.h>

#include "facts/calls.h"
#include "model/codes.h"

namespace tzc::rewriter {

void ValueFlow::check_source_of(const clang::VarDecl* variable) {
  const EntityId id = entities_.declare(variable);
  if (id.empty() || !variable->getInit() || variable->isCXXForRangeDecl() || variable->isImplicit()) return;
  if (llvm::isa<clang::ParmVarDecl>(variable) || variable->getInit()->isTypeDependent()) return;
  if (!sources_of(variable->getInit()).foreign) return;
  entities_.add_obstacle(
      id, entities_.is_message(id) ? codes::TZC1013 : codes::TZC1017,
      "it starts as '" + unit_.text(variable->getInit()) + "', which code outside the package builds",
      variable->getLocation());
}

void ValueFlow::check_const_cast(const clang::ExplicitCastExpr* cast) {
  const clang::Expr* from = cast->getSubExpr();
  if (!removes_const(cast) || !carried_by(from->getType(), unit_.rules)) return;
  if (serves_plain_field(unit_, cast)) return;
  for (const EntityId& id : sources_of(from).entities)
    entities_.add_obstacle(id, codes::TZC2002, "const is cast away from it", cast->getBeginLoc());
}

void ValueFlow::loop_over(const clang::CXXForRangeStmt* loop) {
  const EntityId variable = loop->getLoopVariable() ? entities_.declare(loop->getLoopVariable()) : EntityId();
  if (variable.empty() || !loop->getRangeInit()) return;
  for (const EntityId& id : sources_of(loop->getRangeInit()).entities)
    entities_.add_flow(id, variable, loop->getForLoc(), "looped over");
}

}  // namespace tzc::rewriter
