// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/calls.h"

#include <set>

#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

const clang::MemberExpr* callee_of(const clang::CXXMemberCallExpr* call) {
  return llvm::dyn_cast<clang::MemberExpr>(call->getCallee()->IgnoreParens());
}

/// Whether what is const in one type is not in the other, at any depth of raw and smart pointers.
bool loses_const(clang::QualType before, clang::QualType after) {
  while (!before.isNull() && !after.isNull()) {
    if (before.isConstQualified() && !after.isConstQualified()) return true;
    before = pointee_of(before);
    after = pointee_of(after);
  }
  return false;
}

template <class Call>
unsigned count_written(const Call* call) {
  const auto is_written = [](const clang::Expr* argument) {
    return !llvm::isa<clang::CXXDefaultArgExpr>(argument);
  };
  return static_cast<unsigned>(llvm::count_if(call->arguments(), is_written));
}

}  // namespace

Receiver receiver_of(const clang::CXXMemberCallExpr* call) {
  const clang::MemberExpr* callee = callee_of(call);
  if (!callee) return {};
  const clang::Expr* base = callee->getBase()->IgnoreParenImpCasts();
  if (llvm::isa<clang::CXXThisExpr>(base)) return {base, true};
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(base);
  if (op && op->getOperator() == clang::OO_Arrow) return {op->getArg(0)->IgnoreImpCasts(), true};
  return {callee->getBase()->IgnoreImpCasts(), callee->isArrow()};
}

std::string written_template_arguments(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::MemberExpr* callee = callee_of(call);
  if (!callee || !callee->hasExplicitTemplateArgs() || callee->getNumTemplateArgs() == 0) return "";
  const clang::SourceRange range(
      callee->getTemplateArgs()[0].getSourceRange().getBegin(),
      callee->getTemplateArgs()[callee->getNumTemplateArgs() - 1].getSourceRange().getEnd());
  return unit.source.text(range);
}

unsigned written_arguments(const clang::CallExpr* call) {
  return count_written(call);
}

unsigned written_arguments(const clang::CXXConstructExpr* construct) {
  return count_written(construct);
}

bool passes_through(const clang::FunctionDecl* function) {
  static const std::set<std::string> names = {
      "std::move",      "std::forward",     "std::ref",      "std::cref",
      "boost::move",    "boost::forward",   "boost::ref",    "boost::cref",
      "std::addressof", "boost::addressof", "tzc::attached", "tzc::image_transport::attached"};
  // std::move(first, last, out) moves elements.
  return function && function->getNumParams() == 1 && names.count(qualified_name_of(function)) != 0;
}

bool casts_pointer(const clang::FunctionDecl* function) {
  return function && function->getIdentifier() && function->getName().ends_with("_pointer_cast");
}

bool recasts_pointer(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!casts_pointer(function) || unit.declares(function) || call->getNumArgs() != 1 ||
      llvm::isa<clang::CXXMethodDecl>(function))
    return false;
  const auto from = carried_by(call->getArg(0)->getType(), unit.rules);
  const auto to = carried_by(call->getType(), unit.rules);
  if (!from || !to || from->role != to->role || from->rename != to->rename) return false;
  if (!from->message || !to->message) return !from->message && !to->message;
  return from->message->name == to->message->name;
}

bool makes_object(const clang::CallExpr* call) {
  static const std::set<std::string> names = {"boost::make_shared", "std::make_shared", "std::make_unique",
                                              "boost::make_unique"};
  const clang::FunctionDecl* function = call->getDirectCallee();
  return function && names.count(qualified_name_of(function)) != 0;
}

bool makes_several(const clang::Expr* made) {
  const auto* expr = llvm::dyn_cast<clang::CXXNewExpr>(made);
  if (expr) return expr->isArray();
  const clang::QualType object = first_argument(made->getType());
  return !object.isNull() && object->isArrayType();
}

const clang::CXXRecordDecl* class_that_is_made(const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  const bool makes = function && function->getIdentifier() && function->getName().starts_with("make_");
  const clang::TemplateArgumentList* arguments = makes ? function->getTemplateSpecializationArgs() : nullptr;
  if (!arguments || arguments->size() == 0 || (*arguments)[0].getKind() != clang::TemplateArgument::Type)
    return nullptr;
  return (*arguments)[0].getAsType()->getAsCXXRecordDecl();
}

bool builds_message(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) return false;
  const std::string name = qualified_name_of(function);
  return llvm::any_of(unit.rules.methods, [&](const MethodCall* rule) {
    return rule->role == MethodCall::Role::builds_message &&
           (name == rule->to || name == std::string(rule->object) + "::" + rule->method);
  });
}

std::optional<FillingCall> filling_call(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) return {};
  const std::string name = qualified_name_of(function);
  const bool is_method = llvm::isa<clang::CXXMemberCallExpr>(call);
  for (const MethodCall* rule : unit.rules.methods) {
    if (rule->role != MethodCall::Role::fills_message) continue;
    const bool is_written = name == rule->to;
    if (!is_written && !(is_method && name == std::string(rule->object) + "::" + rule->method)) continue;
    const unsigned at = is_written ? rule->filled + 1 : rule->filled;  // behind the object
    if (at >= call->getNumArgs()) continue;
    const clang::QualType type = call->getArg(at)->getType();
    const std::optional<MessageType> stock = message_of(type);
    const std::optional<MessageType> message = stock ? stock : twin_message_of(type);
    if (message && (!rule->message || message->name == rule->message))
      return FillingCall{rule, call->getArg(at)};
  }
  return {};
}

const clang::Expr* pointer_followed(const clang::Expr* expr) {
  const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr);
  if (op && op->getOpcode() == clang::UO_Deref) return op->getSubExpr()->IgnoreParenImpCasts();
  const auto* call = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr);
  const bool follows = call && call->getOperator() == clang::OO_Star && call->getNumArgs() == 1;
  return follows ? call->getArg(0)->IgnoreParenImpCasts() : nullptr;
}

bool is_single_subscriber(const std::string& name) {
  return name == "ros::SingleSubscriberPublisher" || name == "image_transport::SingleSubscriberPublisher";
}

bool is_publisher_class(const std::string& name) {
  static const std::set<std::string> names = {"Publisher", "CameraPublisher"};
  static const std::set<std::string> spaces = {
      "ros::", "image_transport::", "tzc::", "tzc::image_transport::"};
  const std::size_t colons = name.rfind("::");
  if (colons == std::string::npos) return false;
  return is_single_subscriber(name) ||
         (names.count(name.substr(colons + 2)) && spaces.count(name.substr(0, colons + 2)));
}

bool removes_const(const clang::ExplicitCastExpr* cast) {
  const clang::QualType before = cast->getSubExprAsWritten()->getType(), after = cast->getType();
  if (cast->isGLValue()) return loses_const(before, after);
  const clang::QualType from = pointee_of(before), to = pointee_of(after);
  return !before->isArrayType() && !from.isNull() && !to.isNull() && loses_const(from, to);
}

bool removes_const(const clang::CallExpr* pointer_cast) {
  return loses_const(pointee_of(pointer_cast->getArg(0)->getType()), pointee_of(pointer_cast->getType()));
}

bool is_null(const Unit& unit, const clang::Expr* pointer) {
  return pointer->isNullPointerConstant(unit.ast(), clang::Expr::NPC_ValueDependentIsNotNull) !=
         clang::Expr::NPCK_NotNull;
}

std::string cast_from(clang::QualType type) {
  return "cast from '" + type.getAsString() + "', which does not tell what lies there";
}

const clang::CallExpr* call_behind(const clang::Expr* value) {
  value = value->IgnoreImplicit();
  const auto* copy = llvm::dyn_cast<clang::CXXConstructExpr>(value);
  if (copy && copy->getNumArgs() == 1) return call_behind(copy->getArg(0));
  return llvm::dyn_cast<clang::CallExpr>(value);
}

bool is_publish(const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  return method && method->getNameAsString() == "publish" &&
         is_publisher_class(qualified_name_of(method->getParent()));
}

bool is_attached_publish(const clang::CallExpr* call) {
  static const std::set<std::string> names = {"tzc::publish", "tzc::image_transport::publish"};
  const clang::FunctionDecl* function = call->getDirectCallee();
  return function && call->getNumArgs() >= 2 && names.count(qualified_name_of(function)) != 0;
}

llvm::ArrayRef<const clang::Expr*> published_by(const clang::CallExpr* call) {
  const llvm::ArrayRef<const clang::Expr*> arguments(call->getArgs(), call->getNumArgs());
  const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  if (member && is_publish(member)) return arguments;
  return !member && is_attached_publish(call) ? arguments.drop_front() : llvm::ArrayRef<const clang::Expr*>();
}

std::optional<std::string> written_text(const Unit& unit, const clang::CallExpr* call, unsigned index) {
  if (written_arguments(call) <= index) return {};
  return unit.text(call->getArg(index));
}

bool is_template_parameter(const clang::TemplateArgument& argument) {
  return argument.getKind() == clang::TemplateArgument::Type &&
         argument.getAsType()->getAs<clang::SubstTemplateTypeParmType>() != nullptr;
}

std::optional<std::string> constant_string(const clang::Expr* expr) {
  for (;;) {
    expr = expr->IgnoreParenImpCasts();
    if (const auto* literal = llvm::dyn_cast<clang::StringLiteral>(expr)) return literal->getString().str();
    if (const auto* full = llvm::dyn_cast<clang::FullExpr>(expr)) {
      expr = full->getSubExpr();
    } else if (const auto* temporary = llvm::dyn_cast<clang::MaterializeTemporaryExpr>(expr)) {
      expr = temporary->getSubExpr();
    } else if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(expr)) {
      expr = bound->getSubExpr();
    } else if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(expr)) {
      expr = cast->getSubExpr();
    } else if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expr);
               made && made->getNumArgs() > 0) {
      expr = made->getArg(0);
    } else {
      return {};
    }
  }
}

}  // namespace tzc::rewriter
