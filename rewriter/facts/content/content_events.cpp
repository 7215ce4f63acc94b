// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/content_reader.h"

#include "facts/content/bound_elements.h"
#include "facts/content/started_pointers.h"
#include "facts/flow/overwrites.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/bodies.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/light_types.h"
#include "facts/syntax/made_vectors.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

using Kind = ContentEvent::Kind;

/// `return frame;`: the caller's object is this one, or has what it had.
bool is_returned(const FunctionView& view, const clang::Stmt* value) {
  const clang::Stmt* around = view.parent(value);
  while (around && is_implicit_wrapper(around)) around = view.parent(around);
  return llvm::isa_and_nonnull<clang::ReturnStmt>(around);
}

/// "ROOT/image/data"; a vector of the program's own has a root alone.
bool is_of_message(const MessagePart& array) {
  return array.find('/') != MessagePart::npos;
}

bool is_constant(const Unit& unit, const clang::Expr* expr) {
  return !expr->isValueDependent() && expr->isEvaluatable(unit.ast());
}

bool is_constant_zero(const clang::Expr* expr) {
  const auto* literal = llvm::dyn_cast<clang::IntegerLiteral>(expr->IgnoreParenImpCasts());
  return literal && literal->getValue() == 0;
}

/// A library's, or an array.
bool is_foreign_container(const Unit& unit, clang::QualType type) {
  const clang::QualType pointee = pointee_of(type);
  const clang::QualType whole = pointee.isNull() ? type.getNonReferenceType() : pointee;
  const clang::CXXRecordDecl* record = whole->getAsCXXRecordDecl();
  const bool is_foreign = record ? !unit.source.in_package(record->getLocation()) : whole->isArrayType();
  return is_foreign && !is_message_or_pointer(type) && !is_iterator(type) && message_reached(type);
}

/// Other than one that only passes on what a part of it denotes: std::move(data), (data), data = other
bool denotes_object(const clang::Expr* expr) {
  if (llvm::isa<clang::MemberExpr, clang::DeclRefExpr, clang::ArraySubscriptExpr>(expr)) return true;
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr)) return op->getOpcode() == clang::UO_Deref;
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr))
    return op->isGLValue() && !op->isAssignmentOp();
  const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
  return call && call->isGLValue() && call->getDirectCallee() && !passes_through(call->getDirectCallee());
}

/// std::swap(front.data, back.data)
bool is_swap(const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function || !function->getDeclName().isIdentifier() || function->getName() != "swap") return false;
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  return call->getNumArgs() == (method ? 1 : 2);
}

/// sensor_msgs::PointCloud2Iterator it(cloud, "x"): the cloud; null: something else is made.
const clang::Expr* cloud_of_iterator(const clang::CXXConstructExpr* construct) {
  const std::string name = construct->getConstructor()->getParent()->getNameAsString();
  return name == "PointCloud2Iterator" && construct->getNumArgs() >= 2 ? construct->getArg(0) : nullptr;
}

}  // namespace

void ContentReader::array_method(const clang::Expr* array, const clang::CXXMemberCallExpr* call,
                                 const std::string& name) {
  static const std::set<std::string> replaces = {"clear", "assign"};
  static const std::set<std::string> keeps = {"resize", "reserve", "shrink_to_fit", "bind"};
  const bool is_const = call->getMethodDecl()->isConst();
  if (is_const) return;
  if (name == "swap") return exchanged(array, call->getArg(0), call->getExprLoc());
  bool resets = replaces.count(name) != 0;
  if (name == "resize") {
    resets =
        is_constant_zero(call->getArg(0)) || written_arguments(call) == 2 || without_zero_fill(unit_, call);
    if (written_arguments(call) == 2) {
      const clang::CXXRecordDecl* tag = call->getArg(1)->getType()->getAsCXXRecordDecl();
      resets = tag && tag->getName() == "uninitialized_t";
    }
  }
  const bool has_elements = name == "assign" || (name == "resize" && !is_constant_zero(call->getArg(0)));
  if (resets) return log_.assign(parts_.part_of(array), !has_elements, call->getExprLoc());
  const bool sets_size = name == "resize" || name == "reserve";
  const bool may_vary = sets_size && !is_constant(unit_, call->getArg(0));
  if (sets_size) log_.add(may_vary ? Kind::grow : Kind::fill, parts_.part_of(array), call->getExprLoc());
  if (keeps.count(name) == 0) log_.add(Kind::write, parts_.part_of(array), call->getExprLoc());
}

/// The array is given another one's elements: they lie in shared memory where that is a message's.
void ContentReader::replaced(const clang::Expr* array, const clang::Expr* source) {
  const MessagePart part = parts_.part_of(array);
  const bool of_message = is_of_message(parts_.part_of(source));
  if (of_message || is_made_empty(source))
    log_.assign(part, true, array->getExprLoc());
  else
    log_.add(Kind::take, part, array->getExprLoc());
  if (of_message) log_.pair(Kind::exchange, part, parts_.part_of(source), array->getExprLoc());
}

/// Messages, arrays, or pointers to messages.
void ContentReader::exchanged(const clang::Expr* one, const clang::Expr* other, clang::SourceLocation where) {
  const clang::QualType type = one->IgnoreParenImpCasts()->getType();
  if (!is_message_or_pointer(type) && !is_stock_or_twin_array(type)) return;
  const auto is_vector = [&](const clang::Expr* expr) {
    return is_stock_or_twin_array(expr->getType()) && !is_of_message(parts_.part_of(expr));
  };
  if (is_vector(other)) return replaced(one, other);
  if (is_vector(one)) return replaced(other, one);
  log_.pair(Kind::exchange, parts_.part_of(one), parts_.part_of(other), where);
}

/// A mention of an array: replaced as a whole, or its elements are reached for writing.
void ContentReader::array(const clang::Expr* expr) {
  if (is_only_read(view_, expr)) return;
  const clang::Stmt* use = use_of(view_, expr);
  if (const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(use)) {
    const auto* call = llvm::dyn_cast_or_null<clang::CXXMemberCallExpr>(view_.parent(member));
    if (call) array_method(expr, call, member->getMemberDecl()->getNameAsString());
    return;
  }
  if (const auto* op = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(use)) {
    if (op->isComparisonOp() || op->isAssignmentOp()) return;  // see array_assigned
    return log_.add(Kind::write, parts_.part_of(expr), expr->getExprLoc());
  }
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(use);
  if (call && (unit_.declares(call->getDirectCallee()) || passes_through(call->getDirectCallee()))) return;
  if (call && is_swap(call)) return;  // see exchanged
  if (llvm::isa_and_nonnull<clang::DeclStmt, clang::CXXConstructExpr>(use))
    return;  // another name, or a copy
  log_.add(Kind::write, parts_.part_of(expr), expr->getExprLoc());
}

/// After what its operands do.
void ContentReader::array_assigned(const clang::CXXOperatorCallExpr* op) {
  const clang::Expr* array = op->getArg(0)->IgnoreParenImpCasts();
  if (!is_stock_or_twin_array(array->getType()) || !denotes_object(array)) return;
  if (takes_elements(op) && assignment_in_place(unit_, op).empty()) return replaced(array, op->getArg(1));
  log_.add(Kind::reset, parts_.part_of(array), array->getExprLoc());
}

/// Elements that it gets have arrays of their own, which allocate has not seen: most lie outside shared memory.
void ContentReader::array_of_messages(const clang::Expr* expr) {
  static const std::set<std::string> adds_none = {"reserve", "begin", "end",  "rbegin", "rend",    "front",
                                                  "back",    "at",    "data", "erase",  "pop_back"};
  if (is_only_read(view_, expr)) return;
  const clang::Stmt* use = use_of(view_, expr);
  if (llvm::isa_and_nonnull<clang::DeclStmt, clang::CXXConstructExpr>(use))
    return;  // another name, or a copy
  if (const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(use)) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member->getMemberDecl());
    const std::string name = member->getMemberDecl()->getNameAsString();
    if (name == "clear") return log_.add(Kind::reset, parts_.part_of(expr), expr->getExprLoc());
    if (!method || method->isConst() || adds_none.count(name) != 0) return;
  }
  const auto* op = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(use);
  if (op && (!op->isAssignmentOp() || op->getArg(0)->IgnoreParenImpCasts() != expr)) return;
  if (adds_bound_elements(view_, expr)) return;
  // A container of the program's own is none: given_messages.cpp tells of what it gets.
  if (MessagePart array = parts_.part_of(expr); is_of_message(array) || is_parameter(array))
    log_.add(Kind::take, std::move(array), expr->getExprLoc());
}

/// A camera's calibration, which goes out beside the image that the site is about: a few numbers, not its elements.
void ContentReader::publish(const clang::CallExpr* call) {
  for (const clang::Expr* argument : published_by(call)) {
    if (!is_message_or_pointer(argument->getType())) continue;
    const std::optional<MessageType> message = message_reached(argument->getType());
    const bool is_beside = argument != published_by(call).front();
    if (is_beside && message && light_type_bytes(message->name)) continue;
    log_.any(argument);
    const Place place = unit_.source.where(call->getExprLoc());
    log_.publish(parts_.part_of(argument), {place.file, place.begin}, call->getExprLoc());
  }
}

/// A function of a library that fills a message as a whole, or what an earlier run made of it.
bool ContentReader::rule_call(const clang::CallExpr* call, const std::string& name) {
  for (const LibraryCall* rule : unit_.rules.calls) {
    if ((name != rule->function && name != rule->to) || rule->argument >= call->getNumArgs()) continue;
    const MessagePart part = parts_.part_of(call->getArg(rule->argument));
    if (rule->elements == LibraryCall::Elements::filled) log_.add(Kind::reset, part, call->getExprLoc());
    if (rule->elements == LibraryCall::Elements::of_vector) log_.add(Kind::take, part, call->getExprLoc());
    return true;
  }
  const std::optional<FillingCall> filling = filling_call(unit_, call);
  if (filling) log_.add(Kind::reset, parts_.part_of(filling->message), call->getExprLoc());
  return filling.has_value();
}

void ContentReader::package_call(const clang::FunctionDecl* function,
                                 llvm::ArrayRef<const clang::Expr*> arguments, const clang::Stmt* at) {
  ContentEvent event;
  event.kind = Kind::call;
  const std::string callee = usr_of(pattern_of(function));
  if (!may_have_another_body(function)) event.callee = callee;
  event.where = unit_.location(at->getBeginLoc());
  if (returns_message(function)) event.part = result_root(callee);
  for (unsigned i = 0; i < arguments.size() && i < function->getNumParams(); ++i) {
    const clang::QualType type = arguments[i]->getType();
    if (is_foreign_container(unit_, type))  // whose elements have other names in the callee
      log_.any(arguments[i], message_reached(type)->name);
    const bool is_array = is_stock_or_twin_array(type) || is_pointer_to_array(type);
    if (!is_message_or_pointer(type) && !is_iterator(type) && !is_array) continue;
    if (MessagePart part = parts_.part_of(arguments[i]); part.empty())
      log_.any(arguments[i]);
    else
      event.passed.emplace(parameter_root(callee, i), std::move(part));
  }
  log_.step(CallOfPackage{});
  log_.step(std::move(event));
  log_.step(CallOfPackage{});
}

void ContentReader::member_call(const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  if (!method) return;
  if (is_publish(call)) return publish(call);
  const clang::Expr* object = call->getImplicitObjectArgument();
  const std::string name = method->getNameAsString();
  if (!object || !is_message_or_pointer(object->IgnoreParenImpCasts()->getType()))
    return;  // not its base class
  if (name == "reset") {
    log_.add(Kind::reset, parts_.part_of(object), call->getExprLoc());
    if (call->getNumArgs() > 0)
      log_.pair(Kind::alias, parts_.part_of(object), parts_.part_of(call->getArg(0)), call->getExprLoc());
  }
  if (name == "swap" && is_swap(call)) exchanged(object, call->getArg(0), call->getExprLoc());
}

/// An object of the class comes into being, and the messages that it consists of with it. Which ones its pointers start with, a constructor
/// that is written says itself (content_names.cpp); null: which one makes the object is not seen.
void ContentReader::made(const clang::CXXRecordDecl* record, const clang::CXXConstructorDecl* by,
                         clang::SourceLocation where) {
  for (const clang::FieldDecl* field : messages_in(unit_, record))
    log_.add(Kind::make, parts_.root_of(field), where);
  if (by && by->isUserProvided()) return;
  for (const clang::FieldDecl* field : started_pointers(unit_, record))
    log_.add(Kind::make, parts_.root_of(field), where);
}

/// frame = std::move(other), queue_.push_back(frame): the messages of an object are another one's, which nothing has bound.
void ContentReader::moved_whole(const clang::Stmt* stmt) {
  const auto take = [&](const clang::Expr* object, bool empties) {
    for (const clang::FieldDecl* field : messages_in(unit_, object->getType()->getAsCXXRecordDecl()))
      if (empties)
        log_.assign(parts_.root_of(field), true, object->getExprLoc());
      else
        log_.add(Kind::take, parts_.root_of(field), object->getExprLoc());
  };
  const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt);
  if (made && made->getConstructor()->isCopyOrMoveConstructor() && !made->isElidable() &&
      !is_returned(view_, made))
    return take(made, false);
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(stmt);
  if (op && op->getOperator() == clang::OO_Equal && takes_elements(op))
    return take(op->getArg(0), is_made_empty(op->getArg(1)));
  const clang::FunctionDecl* function = call && !op ? call->getDirectCallee() : nullptr;
  if (!function || unit_.declares(function) || passes_through(function)) return;
  for (const clang::Expr* argument : call->arguments()) take(argument, false);
}

/// An expression that denotes an array, or points to one that a member of is used: data, (*h), h->
void ContentReader::mention(const clang::Expr* expr) {
  if (is_pointer_to_array(expr->getType())) {
    const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(view_.parent(expr));
    if (member && member->isArrow()) array(expr);
    return;
  }
  if (!is_stock_or_twin_array(expr->getType()) || !denotes_object(expr)) return;
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr); member && !is_only_read(view_, expr))
    log_.any(member->getBase());
  array(expr);
}

/// A function object ends without a call of what it holds, whose own end may run a destructor.
void ContentReader::ended_in_library(clang::QualType type, const IfShown& runs) {
  const clang::CXXRecordDecl* const record = type->getAsCXXRecordDecl();
  if (record && record->getName() == "function")
    log_.step(PerhapsCall{call_of_others(), runs});
  else
    log_.step(UnknownCall{runs});
}

void ContentReader::look_at(const clang::Stmt* stmt) {
  if (const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt)) {
    names_.look_at(lambda);
    return closures_.made(lambda);
  }
  if (const auto* expr = llvm::dyn_cast<clang::Expr>(stmt)) mention(expr);
  names_.look_at(stmt);
  moved_.look_at(stmt);
  moved_whole(stmt);
  ended_.look_at(stmt);
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  if (call && closures_.called(call)) return;
  if (const auto runs = unknown_.at(stmt)) log_.step(UnknownCall{*runs});
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(stmt)) {
    const clang::Expr* const cloud = cloud_of_iterator(construct);
    if (const MessagePart part = cloud ? parts_.part_of(cloud) : MessagePart(); !part.empty())
      log_.add(Kind::write, part + "/data", construct->getBeginLoc());
    if (!construct->getConstructor()->isCopyOrMoveConstructor())
      made(construct->getConstructor()->getParent(), construct->getConstructor(), construct->getBeginLoc());
    if (unit_.declares(construct->getConstructor()))
      package_call(construct->getConstructor(), {construct->getArgs(), construct->getNumArgs()}, construct);
    return;
  }
  if (call) {
    const clang::FunctionDecl* function = call->getDirectCallee();
    if (makes_object(call))
      made(pointee_of(call->getType())->getAsCXXRecordDecl(), nullptr, call->getBeginLoc());
    if (is_swap(call) && call->getNumArgs() == 2 && !unit_.declares(function))
      exchanged(call->getArg(0), call->getArg(1), call->getExprLoc());
    if (const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call)) member_call(member);
    if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call); op && op->isAssignmentOp())
      array_assigned(op);
    if (is_attached_publish(call)) return publish(call);
    if (!function || rule_call(call, qualified_name_of(function))) return;
    if (!unit_.declares(function)) return closures_.given_to(call);
    const bool shifted =
        llvm::isa<clang::CXXOperatorCallExpr>(call) && llvm::isa<clang::CXXMethodDecl>(function);
    llvm::ArrayRef<const clang::Expr*> arguments(call->getArgs(), call->getNumArgs());
    return package_call(function, shifted ? arguments.drop_front() : arguments, call);
  }
  const auto* expr = llvm::dyn_cast<clang::Expr>(stmt);
  if (!expr || !llvm::isa<clang::MemberExpr, clang::DeclRefExpr>(expr)) return;
  if (is_array_of_data_parts(expr->getType())) array_of_messages(expr);
}

}  // namespace tzc::rewriter
