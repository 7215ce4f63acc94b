// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/callback_parameter.h"

#include <clang/AST/DeclTemplate.h>

namespace tzc::rewriter {
namespace {

const clang::ClassTemplateSpecializationDecl* template_of(clang::QualType type) {
  return llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(
      type.getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl());
}

/// pcl_ros makes a cloud of the message; the callback has it to itself.
CallbackParameter cloud_parameter() {
  MessageType message;
  message.name = "sensor_msgs/PointCloud2";
  message.has_data_part = message.has_direct_data_part = true;
  message.most_bytes.reset();
  return {message, false, true};
}

}  // namespace

CallbackParameter callback_parameter_of(clang::QualType type) {
  const bool by_value = !type->isReferenceType();
  const clang::QualType bare = type.getNonReferenceType();
  if (is_pcl_cloud(bare)) return cloud_parameter();
  if (const auto message = message_of(bare)) return {message, by_value || !bare.isConstQualified()};
  const clang::QualType pointee = pointee_of(bare);
  if (!pointee.isNull()) return {message_of(pointee), !pointee.isConstQualified()};
  const auto* event = template_of(bare);
  if (!event || event->getName() != "MessageEvent") return {};
  const clang::QualType inner = event->getTemplateArgs()[0].getAsType();
  return {message_of(inner), !inner.isConstQualified()};
}

namespace {

/// The message parameters of a function type, in the first of them that has one.
CallbackParameter parameter_in(clang::QualType type) {
  if (type.isNull()) return {};
  type = type.getNonReferenceType();
  if (const auto* member = type->getAs<clang::MemberPointerType>()) type = member->getPointeeType();
  if (type->isFunctionPointerType()) type = type->getPointeeType();
  const auto* function = type->getAs<clang::FunctionProtoType>();
  if (!function) return {};
  CallbackParameter found;
  for (const clang::QualType parameter : function->param_types()) {
    const CallbackParameter one = callback_parameter_of(parameter);
    if (one.message && !found.message) found = one;
    if (one.message && one.message->name == found.message->name) found.writes = found.writes || one.writes;
  }
  return found;
}

}  // namespace

CallbackParameter callback_parameter_of(const clang::CallExpr* call) {
  for (const clang::Expr* argument : call->arguments()) {
    const CallbackParameter found = parameter_in(argument->IgnoreParenImpCasts()->getType());
    if (found.message) return found;
  }
  for (const clang::Expr* argument : call->arguments()) {
    const CallbackParameter found = parameter_in(argument->getType());
    if (found.message) return found;
  }
  const clang::FunctionDecl* callee = call->getDirectCallee();
  const clang::TemplateArgumentList* arguments = callee ? callee->getTemplateSpecializationArgs() : nullptr;
  if (!arguments) return {};
  // subscribe<M>(topic, n, function) or subscribe<M, C>(...): C is what the callback takes.
  CallbackParameter found;
  for (const clang::TemplateArgument& argument : arguments->asArray()) {
    if (argument.getKind() != clang::TemplateArgument::Type) continue;
    const clang::QualType type = argument.getAsType();
    const bool is_message = message_of(type).has_value() && !type->isReferenceType();
    const CallbackParameter one =
        is_message ? CallbackParameter{message_of(type), false} : callback_parameter_of(type);
    if (one.message) found = one;
  }
  return found;
}

}  // namespace tzc::rewriter
