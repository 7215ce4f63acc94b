// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/type_origins.h"

#include <clang/AST/DeclTemplate.h>
#include <llvm/ADT/STLExtras.h>

#include "parse/names.h"

namespace tzc::rewriter {
namespace {

/// M of M, const M& and M&&; null: the type is something else.
const clang::TemplateTypeParmType* parameter_in(clang::QualType type) {
  return type.getNonReferenceType()->getAs<clang::TemplateTypeParmType>();
}

/// Whether nothing but what is given for this parameter of a function template tells its type: B of assign(const A&, B&), and any `auto`.
bool is_deduced_alone(const clang::ParmVarDecl* parameter) {
  const auto* function = llvm::dyn_cast<clang::FunctionDecl>(parameter->getDeclContext());
  if (!function || !function->getPrimaryTemplate()) return false;
  const clang::FunctionDecl* pattern = pattern_of(function);
  const unsigned index = parameter->getFunctionScopeIndex();
  if (index >= pattern->getNumParams()) return false;  // of a pack
  const clang::TemplateTypeParmType* own = parameter_in(pattern->getParamDecl(index)->getType());
  return own && llvm::all_of(pattern->parameters(), [&](const clang::ParmVarDecl* other) {
           if (other->getFunctionScopeIndex() == index || !other->getType()->isDependentType()) return true;
           const clang::TemplateTypeParmType* its = parameter_in(other->getType());
           return its && (its->getDepth() != own->getDepth() || its->getIndex() != own->getIndex());
         });
}

/// Something else keeps the copy's type as it is, and the port can write a conversion to it.
bool takes_stock_message(const EntityFacts& facts, const Flow& flow) {
  const auto copy = facts.entities.find(flow.to);
  return !flow.as_stock.empty() && copy != facts.entities.end() && !copy->second.obstacles.empty();
}

}  // namespace

void TypeOrigins::note(const EntityId& id, clang::TypeLoc written) {
  (written.getContainedAutoTypeLoc() ? follow_ : written_).insert(id);
}

void TypeOrigins::note(const EntityId& id, const clang::ParmVarDecl* parameter) {
  if (is_deduced_alone(parameter)) follow_.insert(id);
}

std::set<EntityId> TypeOrigins::fixed(const EntityFacts& facts) const {
  std::set<EntityId> found;
  for (const EntityId& id : written_) {
    const auto entity = facts.entities.find(id);
    if (entity != facts.entities.end() && entity->second.changes.empty() && follow_.count(id) == 0)
      found.insert(id);
  }
  for (std::size_t known = 0; known != found.size();) {
    known = found.size();
    for (const Flow& flow : facts.flows)
      if (!flow.copies && found.count(flow.from) != 0 && follow_.count(flow.to) != 0) found.insert(flow.to);
  }
  return found;
}

void TypeOrigins::tie(EntityFacts& facts) const {
  const std::set<EntityId> fixed = this->fixed(facts);
  for (Flow& flow : facts.flows)
    flow.copies = flow.copies && (fixed.count(flow.to) == 0 || takes_stock_message(facts, flow));
}

}  // namespace tzc::rewriter
