// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>
#include <clang/AST/TypeLoc.h>
#include <llvm/ADT/STLFunctionalExtras.h>

#include <string>
#include <vector>

#include "facts/flow/array_bounds.h"
#include "facts/flow/type_origins.h"
#include "facts/syntax/message_type.h"
#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// How a value goes from one entity to another, as of Flow.
struct Passage {
  clang::SourceLocation where;
  std::string what;
  bool copies = false;
  std::vector<Change> as_stock = {};
};

/// The entities of a unit and the flows between them. Only this class writes them; its functions ignore empty
/// ids.
class EntityTable {
 public:
  explicit EntityTable(const Unit& unit) : unit_(unit) {}

  /// The entity of a variable, member or parameter of the package. Empty: it carries nothing.
  EntityId declare(const clang::ValueDecl* decl);
  /// The entity of a function's result. Empty: it carries nothing.
  EntityId declare_result(const clang::FunctionDecl* function);
  /// The entity of an expression that names its type: new M, M(), make_shared<M>(), a cast.
  EntityId declare_temporary(const clang::Expr* expr);
  /// The id of a function's result, also of one that is no entity.
  EntityId result_id(const clang::FunctionDecl* function) const;

  /// Adds the edits that give the written type its ported spelling, or the obstacles.
  void retype(const EntityId& id, clang::TypeLoc written);
  void add_flow(const EntityId& from, const EntityId& to, const Passage& passage);
  void add_obstacle(const EntityId& id, const Obstacle& obstacle);
  void add_obstacle(const EntityId& id, const char* code, const std::string& reason,
                    clang::SourceLocation where);
  void add_use(const EntityId& id, Change change);
  void add_data_use(const EntityId& id, clang::SourceLocation where, const ArrayGrowth& growth = {});

  /// Null: no entity has this id.
  const Entity& operator[](const EntityId& id) const;
  bool is_message(const EntityId& id) const { return (*this)[id].role == EntityRole::message; }
  const EntityFacts& facts() const { return facts_; }
  /// At the end.
  EntityFacts take();

 private:
  using Description = llvm::function_ref<void(Entity&)>;

  Entity& entity_at(const EntityId& id, const Carried& carried, Description describe);
  void check_type(Entity& entity, const Carried& carried) const;
  void check_signature(Entity& entity, const clang::FunctionDecl* function);
  void check_exported(Entity& entity, const clang::ValueDecl* decl);
  void connect_overrides(const EntityId& id, const clang::FunctionDecl* function, int parameter);
  void respell(Entity& entity, clang::TypeLoc written);

  const Unit& unit_;
  EntityFacts facts_;
  TypeOrigins types_;
};

}  // namespace tzc::rewriter
