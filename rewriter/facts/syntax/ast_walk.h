// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The three ways up in an AST: the node around a node, all nodes around it, the function around it.

#include <clang/AST/ASTContext.h>
#include <clang/AST/ASTTypeTraits.h>
#include <clang/AST/Expr.h>
#include <clang/AST/ParentMapContext.h>
#include <clang/AST/Stmt.h>

#include <optional>
#include <string>
#include <vector>

namespace tzc::rewriter {

/// The node directly around a node, where the source has it: a default argument or initializer belongs to its declaration,
/// not to one of the calls and constructors that use it (Clang 19 names them, too, and 16 does not). None: the top.
std::optional<clang::DynTypedNode> written_parent(clang::ASTContext& ast, const clang::DynTypedNode& node);

/// The same of all trees that share the node, that parent first: a template's instances share with it what does not depend on its
/// parameters.
std::vector<clang::DynTypedNode> written_parents(clang::ASTContext& ast, const clang::DynTypedNode& node);

/// The same, when it is a T; null otherwise.
template <class T, class Node>
const T* parent_as(clang::ASTContext& ast, const Node& node) {
  const auto parent = written_parent(ast, clang::DynTypedNode::create(node));
  return parent ? parent->template get<T>() : nullptr;
}

/// The nodes around a node, innermost first, as a range.
class Ancestors {
 public:
  class Iterator {
   public:
    Iterator(clang::ASTContext& ast, const clang::DynTypedNode& of) : ast_(&ast), node_(of) { ++*this; }
    Iterator(clang::ASTContext& ast) : ast_(&ast), at_end_(true) {}
    const clang::DynTypedNode& operator*() const { return node_; }
    Iterator& operator++();
    bool operator!=(const Iterator& other) const { return at_end_ != other.at_end_; }

   private:
    clang::ASTContext* ast_;
    clang::DynTypedNode node_;
    bool at_end_ = false;
  };

  Ancestors(clang::ASTContext& ast, clang::DynTypedNode of) : ast_(ast), of_(of) {}
  Iterator begin() const { return {ast_, of_}; }
  Iterator end() const { return {ast_}; }

 private:
  clang::ASTContext& ast_;
  clang::DynTypedNode of_;
};

template <class Node>
Ancestors ancestors(clang::ASTContext& ast, const Node& node) {
  return {ast, clang::DynTypedNode::create(node)};
}

/// The innermost function or lambda around a statement; null outside of functions.
const clang::FunctionDecl* enclosing_function(clang::ASTContext& ast, const clang::Stmt& stmt);
/// Its qualified name, or that of the function around the lambda; empty outside of functions.
std::string enclosing_function_name(clang::ASTContext& ast, const clang::Stmt& stmt);
/// Whether a function is an instance of a template, or stands in one of a class or function.
bool is_instance(const clang::FunctionDecl* function);
/// USR of the class whose `this` the function has, a lambda that of the function around it if it may capture that. Empty: none.
std::string record_usr_of(const clang::FunctionDecl* function);

/// The names of the namespaces around a declaration, "a::b"; those without a name need none.
std::string namespaces_around(const clang::Decl* decl);

/// Whether nothing uses the value of an expression: it is a statement of its own, or a part of one that has no value.
bool is_statement(clang::ASTContext& ast, const clang::Expr& expr);

/// Parentheses around an expression, and nodes that nobody wrote. Null is neither.
bool is_wrapping(const clang::Stmt* around);
/// object = value, object += 1, ++object, also by an operator of its class: `around` lies directly around the object.
bool is_assigned(const clang::Stmt* around, const clang::Stmt* object);
bool is_lambda(const clang::FunctionDecl* function);

/// ({ ...; label: value; }): whether it is such a value, by a function that gives a statement's parent.
template <class ParentOf>
bool is_value_of_statements(const clang::Stmt* value, const ParentOf& parent_of) {
  const clang::Stmt* around = parent_of(value);
  while (llvm::isa_and_nonnull<clang::LabelStmt, clang::AttributedStmt>(around)) {
    value = around;
    around = parent_of(value);
  }
  const auto* block = llvm::dyn_cast_or_null<clang::CompoundStmt>(around);
  return block && block->body_back() == value && llvm::isa_and_nonnull<clang::StmtExpr>(parent_of(block));
}

/// The operand of a cast, and of what nobody wrote around an expression; null: it is neither.
const clang::Expr* converted(const clang::Expr* expr);

/// Parentheses, implicit casts and temporaries: the unwritten nodes around an expression.
bool is_implicit_wrapper(const clang::Stmt* stmt);

}  // namespace tzc::rewriter
