// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a publisher's name reads on its way, and what may change it under another name: a reference, a pointer, an iterator, an element.

#include <clang/AST/ExprCXX.h>

#include <set>
#include <string>
#include <vector>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// The parts of the expression that names a publisher.
struct NameParts {
  std::vector<const clang::VarDecl*> locals;
  std::vector<const clang::ValueDecl*> all;
  std::vector<const clang::ValueDecl*> followed;  ///< those that decide where a step leads
  std::vector<const clang::Expr*> read;           ///< the objects that do: variables, members, elements
  std::vector<clang::QualType> led_to;            ///< by raw pointers and iterators, which keep nothing alive
  std::set<std::string> steps;                    ///< what it follows: "node_->", "pubs_[i]", "*pub"; "i % n"
  bool has_effects = false;
};

/// The type that a raw pointer or an iterator leads to; null: of a smart pointer, which owns its object, and of what is no pointer.
clang::QualType led_to_without_owning(clang::QualType pointer);

/// A mention of a variable or member that leaves it as it is. What a step behind it leads to is another object.
bool only_looks(const Unit& unit, const clang::Expr* mention);

/// The memory that decides where the steps of a name lead. Code changes it
/// - by its name;
/// - by another name of an object of its type, or of a class that has such a part: C++ lets no other lvalue change it. A variable whose
///   address nobody takes has no other name, and two variables or fields are two objects;
/// - in a library, through what the call brings: an object, a reference, a pointer, an iterator;
/// - where code runs that is not seen (is_exposed).
/// What raw pointers and iterators lead to begins and ends, besides, with containers and owners of its type.
class NameReads {
 public:
  /// `body`: of the function that names it; null: none.
  NameReads(const Unit& unit, const NameParts& parts, const clang::Stmt* body);

  /// Whether code that is not seen can change it.
  bool is_exposed() const;
  /// Whether a statement itself, without those in it and without what it calls in the package, may change it.
  bool may_be_changed_by(const clang::Stmt* stmt) const;

 private:
  struct Read {
    const clang::ValueDecl*
        decl;  ///< variable or field; null: what a pointer, a reference or a container leads to
    clang::QualType type;
    bool exposed;
  };
  bool by_call(const clang::CallExpr* call) const;
  bool by_arguments(const clang::FunctionDecl* callee, llvm::ArrayRef<const clang::Expr*> arguments) const;
  bool by_argument(clang::QualType parameter, const clang::Expr* argument) const;
  /// A store to what the expression names.
  bool by_store(const clang::Expr* stored) const;
  bool by_store_to_any(clang::QualType type) const;
  /// What a copy of a pointer or iterator of the type leads to.
  bool by_pointer(clang::QualType type) const;
  bool moves_object(clang::QualType container) const;
  bool is_led_to(clang::QualType type) const;

  const Unit& unit_;
  std::vector<Read> reads_;
  std::vector<clang::QualType> led_to_;
};

}  // namespace tzc::rewriter
