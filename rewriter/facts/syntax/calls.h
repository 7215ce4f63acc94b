// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The spelling of a call in the source, and the edits that change it.

#include <clang/AST/ExprCXX.h>

#include <optional>
#include <string>
#include <vector>

#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// Without default arguments.
unsigned written_arguments(const clang::CallExpr* call);
unsigned written_arguments(const clang::CXXConstructExpr* construct);
/// An argument as it is written; none: it is not.
std::optional<std::string> written_text(const Unit& unit, const clang::CallExpr* call, unsigned index);
/// As written between < and >; empty: none written.
std::string written_template_arguments(const Unit& unit, const clang::CXXMemberCallExpr* call);
/// advertise<T>(...) in a template: T stays written, and stands for the stock message.
bool is_template_parameter(const clang::TemplateArgument& argument);

/// make_shared, make_unique and their likes.
bool makes_object(const clang::CallExpr* call);
/// new Image[2], make_unique<Image[]>(2): allocate is given one message, and `*images` is none where the pointer is one to an array.
bool makes_several(const clang::Expr* made);
/// The class that the template argument of make_shared<T>(...), make_optional<T>(...) and their likes is; null: there is none.
const clang::CXXRecordDecl* class_that_is_made(const clang::CallExpr* call);
/// cv_image.toImageMsg(), and what an earlier run made of it.
bool builds_message(const Unit& unit, const clang::CallExpr* call);
/// A call of a library's method that fills a message which it is given, or of what an earlier run wrote in its place.
struct FillingCall {
  const MethodCall* rule;
  const clang::Expr* message;
};
std::optional<FillingCall> filling_call(const Unit& unit, const clang::CallExpr* call);
/// `pointer` of *pointer; null: it is no such expression.
const clang::Expr* pointer_followed(const clang::Expr* expr);
/// std::move and its likes: the result is the argument.
bool passes_through(const clang::FunctionDecl* function);
/// std::const_pointer_cast and its likes: the result leads to what the argument leads to.
bool casts_pointer(const clang::FunctionDecl* function);
/// Such a call of a library, where the result has the very message, publisher or filter that the argument has.
bool recasts_pointer(const Unit& unit, const clang::CallExpr* call);
/// roscpp's, image_transport's or TZC's publisher.
bool is_publisher_class(const std::string& name);
/// A publisher of one subscriber's status callback.
bool is_single_subscriber(const std::string& name);
/// Whether what a cast yields may be written through, and what it was given may not.
bool removes_const(const clang::ExplicitCastExpr* cast);
/// The same of std::const_pointer_cast and its likes.
bool removes_const(const clang::CallExpr* pointer_cast);
/// nullptr, NULL, 0
bool is_null(const Unit& unit, const clang::Expr* pointer);
/// "cast from 'void *', which does not tell what lies there"
std::string cast_from(clang::QualType type);
/// The call that a value comes from, copies aside; null: it comes from none.
const clang::CallExpr* call_behind(const clang::Expr* value);
/// publisher.publish(...)
bool is_publish(const clang::CXXMemberCallExpr* call);
/// tzc::publish(publisher, message), and its likes for images
bool is_attached_publish(const clang::CallExpr* call);
/// The messages and pointers to messages among the arguments of either of them; none: it is another call.
llvm::ArrayRef<const clang::Expr*> published_by(const clang::CallExpr* call);

/// The object of a member call as written, without the dereference of ->.
struct Receiver {
  const clang::Expr* expr = nullptr;
  bool pointer = false;
};
Receiver receiver_of(const clang::CXXMemberCallExpr* call);

std::optional<std::string> constant_string(const clang::Expr* expr);
/// The calls of this function that fill ros::AdvertiseOptions or SubscribeOptions.
std::vector<const clang::CallExpr*> options_calls(const Unit& unit, const clang::Expr* options);
/// The message that ros::AdvertiseOptions or SubscribeOptions were made for; none: this function does not show it.
std::optional<clang::QualType> options_message(const Unit& unit, const clang::Expr* options);
/// That message as the call that fills the options writes it: M of init<M>(...). Empty: it writes something else, or a macro does.
std::string written_options_message(const Unit& unit, const clang::Expr* options);
/// Whether the options are a variable or member of a template itself. Its instances have some of their own.
bool are_of_pattern(const clang::Expr* options);

}  // namespace tzc::rewriter
