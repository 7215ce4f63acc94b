// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facts/syntax/function_view.h"
#include "facts/syntax/unit.h"
#include "model/content_flow.h"

namespace tzc::rewriter {

/// Which message, or part of one, an expression denotes: through references, pointers and elements of containers.
class MessageParts {
 public:
  MessageParts(const Unit& unit, const FunctionView& view) : unit_(unit), view_(view) {}

  /// Empty: not known.
  MessagePart part_of(const clang::Expr* expr, unsigned depth = 0) const;
  /// The root of a variable of the function, a parameter, a member or a global.
  MessagePart root_of(const clang::ValueDecl* decl) const;
  /// What mentions of the variable denote: its root, or what it is another name of.
  MessagePart name_of(const clang::VarDecl* variable, unsigned depth = 0) const;

 private:
  MessagePart of_binding(const clang::BindingDecl* binding, unsigned depth) const;
  MessagePart of_name(const clang::DeclRefExpr* name, unsigned depth) const;
  MessagePart of_member(const clang::MemberExpr* member, unsigned depth) const;
  MessagePart of_call(const clang::CallExpr* call, unsigned depth) const;
  MessagePart of_pair(const clang::MemberExpr* member, unsigned depth) const;
  MessagePart of_binary(const clang::BinaryOperator* op, unsigned depth) const;
  MessagePart of_operator(const clang::CXXOperatorCallExpr* call, unsigned depth) const;
  MessagePart of_package_call(const clang::FunctionDecl* function, unsigned depth) const;
  MessagePart of_library_call(const clang::CallExpr* call, unsigned depth) const;
  MessagePart of_result(const clang::FunctionDecl* function, unsigned depth) const;
  MessagePart element_of(const clang::Expr* container, const clang::Expr* index, unsigned depth) const;
  std::string found_element(const clang::CallExpr* call) const;
  const clang::Expr* range_of(const clang::VarDecl* variable) const;
  bool is_another_name(const clang::VarDecl* variable) const;

  const Unit& unit_;
  const FunctionView& view_;
};

/// A stock message or its twin.
bool is_stock_or_twin(clang::QualType type);
/// The messages that an object of the package's class consists of.
std::vector<const clang::FieldDecl*> messages_in(const Unit& unit, const clang::CXXRecordDecl* record);
/// A message, or a pointer to one; also a reference to either.
bool is_message_or_pointer(clang::QualType type);
/// Leads to one message after another.
bool is_iterator(clang::QualType type);
/// Other than a message, a pointer to one or an iterator: it leads to messages that lie elsewhere, as a tuple of references.
bool names_messages(clang::QualType type);
/// {&front_, &back_}
bool is_list_of_messages(const clang::Expr* expr);
/// Whether a variable of the type is another name of a message that lies elsewhere: a reference, pointer, iterator or the like.
bool is_name_of_message(clang::QualType type);
/// What a call of a library's function may be given a message by: its object and its arguments.
std::vector<const clang::Expr*> message_sources(const clang::CallExpr* call);
/// A message or an array of one's, by pointer or reference; a message also by value.
bool returns_message(const clang::FunctionDecl* function);
/// A data array of a stock message or of a twin.
bool is_stock_or_twin_array(clang::QualType type);
/// A pointer to such an array.
bool is_pointer_to_array(clang::QualType type);
/// A pointer or reference to one.
bool is_name_of_array(clang::QualType type);
/// An array of messages, or of twins, that have data arrays themselves.
bool is_array_of_data_parts(clang::QualType type);
/// What the expression copies where it makes a message: M(image), new M(*in), make_shared<M>(image). Null: it makes none, or otherwise.
const clang::Expr* copied_message(const clang::Expr* made);
/// The statement that uses what is mentioned, behind conversions.
const clang::Stmt* use_of(const FunctionView& view, const clang::Stmt* mention);
/// Whether only const functions are called through a mention of an array.
bool is_only_read(const FunctionView& view, const clang::Expr* array);

}  // namespace tzc::rewriter
