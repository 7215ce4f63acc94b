// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/library_calls.h"

#include "facts/syntax/calls.h"
#include "facts/syntax/known_functions.h"
#include "facts/syntax/message_type.h"
#include "facts/syntax/package_types.h"
#include "facts/syntax/plain_access.h"

namespace tzc::rewriter {
namespace {

/// std::make_unique<Node>(1), std::vector<Node> nodes(3): no argument names the class whose constructor runs.
bool makes_package_object(const Unit& unit, const clang::FunctionDecl* function) {
  const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(function);
  if (constructor && !constructor->isCopyOrMoveConstructor()) {
    const clang::CXXRecordDecl* record = constructor->getParent();
    const bool is_empty = constructor->isDefaultConstructor() && is_owner_class(qualified_name_of(record)) &&
                          record->getName() != "array";
    if (!is_empty && involves_package(unit, unit.ast().getRecordType(record))) return true;
  }
  const clang::TemplateArgumentList* arguments = function->getTemplateSpecializationArgs();
  return arguments && llvm::any_of(arguments->asArray(), [&](const clang::TemplateArgument& argument) {
           return argument.getKind() == clang::TemplateArgument::Type &&
                  involves_package(unit, argument.getAsType());
         });
}

/// A stock one's, or a twin's, which copies what the stock one does.
bool is_of_message(const Unit& unit, const clang::CXXMethodDecl* method) {
  return message_of(method->getParent()) || twin_message_of(unit.ast().getRecordType(method->getParent()));
}

/// pthread_create(&thread, nullptr, work, this)
bool gives_function(llvm::ArrayRef<const clang::Expr*> arguments) {
  return llvm::any_of(arguments, [](const clang::Expr* argument) {
    const clang::QualType type = argument->IgnoreParenImpCasts()->getType();
    return type->isFunctionType() || type->isFunctionPointerType();
  });
}

}  // namespace

bool calls_no_package_code(const Unit& unit, const clang::FunctionDecl* function,
                           llvm::ArrayRef<const clang::Expr*> arguments) {
  if (unit.declares(function)) return false;
  if (is_plain_access(unit, function)) return true;
  if (function->getBuiltinID() != 0 && function->isExternC()) return !gives_function(arguments);
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (method && is_of_message(unit, method)) return true;
  if (!calls_nothing(qualified_name_of(function)) || makes_package_object(unit, function)) return false;
  // A lambda of this function that is handed over is part of the function's text.
  return llvm::none_of(arguments, [&](const clang::Expr* argument) {
    const clang::QualType type =
        argument->IgnoreParenImpCasts()->getType();  // not the base class that it is passed as
    const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
    return !(record && record->isLambda()) && involves_package(unit, type);
  });
}

bool comes_back(const clang::FunctionDecl* callee) {
  if (callee->isNoReturn()) return false;
  const auto* type = callee->getType()->getAs<clang::FunctionProtoType>();
  const clang::ExceptionSpecificationType spec = type ? type->getExceptionSpecType() : clang::EST_None;
  if (spec == clang::EST_BasicNoexcept || spec == clang::EST_NoexceptTrue || spec == clang::EST_NoThrow ||
      spec == clang::EST_DynamicNone)
    return true;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(callee);
  return (method && (method->isTrivial() || message_of(method->getParent()))) ||
         (callee->getBuiltinID() != 0 && callee->isExternC()) || always_returns(qualified_name_of(callee));
}

}  // namespace tzc::rewriter
