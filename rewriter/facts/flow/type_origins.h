// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Decl.h>
#include <clang/AST/TypeLoc.h>

#include <set>

#include "model/facts.h"

namespace tzc::rewriter {

/// Where entities have their types from. What a port can write gives it a type of its own. `auto`, and the parameter of a function template, has
/// that of what it starts with. M, decltype(in) and std::decay_t<decltype(in)> have one that is said somewhere else, and keep it whatever
/// becomes of the entity.
///
/// A message and its copy may be ported apart only if the copy can be given another type than the original's. A copy with a type that is said
/// somewhere else cannot: it would stay a stock message under the name of a ported one. So it is ported with the original, or not at all.
class TypeOrigins {
 public:
  void note(const EntityId& id, clang::TypeLoc written);
  void note(const EntityId& id, const clang::ParmVarDecl* parameter);
  /// Ties such copies to what they are made of. When all is known.
  void tie(EntityFacts& facts) const;

 private:
  /// What has its type from somewhere else, or starts with that.
  std::set<EntityId> fixed(const EntityFacts& facts) const;

  std::set<EntityId> written_, follow_;
};

}  // namespace tzc::rewriter
