// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ASTTypeTraits.h>
#include <clang/AST/ExprCXX.h>

#include <map>
#include <utility>

#include "facts/flow/call_effects.h"
#include "facts/flow/flow_sources.h"

namespace tzc::rewriter {

/// Where a followed value ended up.
struct FlowEnd {
  const clang::VarDecl* variable = nullptr;  ///< initialised by it
  const clang::FieldDecl* member = nullptr;  ///< likewise
  const clang::Expr* target = nullptr;       ///< assigned or reset to it
  const clang::Expr* statement = nullptr;    ///< the assignment
  const clang::CXXMemberCallExpr* publish = nullptr;
};

/// Forward value flow: follows the value of one expression upwards through the expressions around it.
class UseFollower {
 public:
  UseFollower(const Unit& unit, EntityTable& entities)
      : unit_(unit), entities_(entities), sources_(unit, entities), effects_(unit, entities) {}

  /// Follows the value of `leaf`, which is the entity `id`, to where it ends up: flows, uses, obstacles. A pointer that becomes
  /// another one, as in ImagePtr(new Image), ends where that one does. Each value is followed once.
  FlowEnd follow(const clang::Expr* leaf, const EntityId& id);

 private:
  bool step();
  bool into(const clang::DynTypedNode& around);
  bool into_decl(const clang::Decl* decl);
  bool into_expression(const clang::Expr* parent);
  bool into_member(const clang::MemberExpr* member);
  bool into_method(const clang::MemberExpr* member);
  bool into_list(const clang::InitListExpr* list);
  bool into_operator(const clang::CXXOperatorCallExpr* call);
  bool into_binary(const clang::BinaryOperator* op);
  bool into_call(const clang::CallExpr* call);
  bool into_constructor(const clang::CXXConstructExpr* construct);
  bool into_cast(const clang::ExplicitCastExpr* cast);
  bool into_return(const clang::ReturnStmt* statement);
  bool into_initializer(const clang::CXXConstructorDecl* constructor);
  bool go_on(const clang::Expr* next);
  template <class Call>
  void note_generic_code(const Call* call);
  bool refuse(const char* code, const std::string& reason);
  void assign(const clang::Expr* target, const clang::Expr* value, const clang::Expr* statement);
  void check_source(const clang::Expr* value, bool copies = false);

  const Unit& unit_;
  EntityTable& entities_;
  SourceFinder sources_;
  CallEffects effects_;
  const clang::Expr* at_ = nullptr;
  EntityId id_;
  FlowEnd end_;
  const clang::Expr* handle_ = nullptr;  ///< another pointer that the value becomes
  std::map<std::pair<const clang::Expr*, EntityId>, FlowEnd> ends_;
};

}  // namespace tzc::rewriter
