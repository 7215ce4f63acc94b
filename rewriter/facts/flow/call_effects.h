// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <optional>
#include <string>

#include "facts/flow/deleters.h"
#include "facts/flow/flow_sources.h"

namespace tzc::rewriter {

/// What a call does with a value: uses it and nothing more, or returns it.
enum class CallEffect { done, result };

/// Gives an entity the types that a call names: make_shared<Image>(), publish<Image>(image).
void retype(EntityTable& entities, const EntityId& id, llvm::ArrayRef<clang::TemplateArgumentLoc> written);

/// Whether a cast away from const serves only a field outside of the arrays: that part of a view is private
/// memory.
bool serves_plain_field(const Unit& unit, const clang::Expr* cast);

/// The effect of a call on an entity that is passed to it: the value flows on, takes an edit, or escapes.
class CallEffects {
 public:
  CallEffects(const Unit& unit, EntityTable& entities)
      : unit_(unit), entities_(entities), sources_(unit, entities) {}

  CallEffect of_call(const EntityId& id, const clang::CallExpr* call, unsigned argument);
  CallEffect of_constructor(const EntityId& id, const clang::CXXConstructExpr* construct, unsigned argument);

 private:
  struct Passed {
    const clang::FunctionDecl* function;
    unsigned argument;
    clang::SourceLocation where;
  };
  CallEffect into_function(const EntityId& id, const clang::CallExpr* call, const Passed& passed);
  CallEffect into_package(const EntityId& id, const Passed& passed);
  void into_deleter(const EntityId& id, const Deleter& deleter);
  CallEffect into_method(const EntityId& id, const clang::CXXMemberCallExpr* call, const Passed& passed);
  std::optional<CallEffect> into_bound(const EntityId& id, const clang::Expr* call, unsigned argument);
  void into_new_object(const EntityId& id, const clang::CallExpr* call, unsigned argument);
  CallEffect into_swap(const EntityId& id, const clang::CallExpr* call);
  CallEffect into_pointer_cast(const EntityId& id, const clang::CallExpr* call);
  void escape(const EntityId& id, const std::string& receiver, clang::SourceLocation where);
  void use_rule(const EntityId& id, const clang::CallExpr* call, const LibraryCall& rule);
  void publish_by_method(const EntityId& id, const clang::CallExpr* call);
  void use_rule(const EntityId& id, const clang::CXXMemberCallExpr* call, const MethodCall& rule);

  const Unit& unit_;
  EntityTable& entities_;
  SourceFinder sources_;
};

}  // namespace tzc::rewriter
