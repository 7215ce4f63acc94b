// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/filled_message.h"

#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

const clang::Expr* filled_by(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) return nullptr;
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call))
    return op->getOperator() == clang::OO_Equal ? op->getArg(0) : nullptr;
  for (unsigned i = 0; i < call->getNumArgs(); ++i) {
    const LibraryCall* rule = unit.rules.find_call(qualified_name_of(function), i);
    if (rule) return rule->elements == LibraryCall::Elements::left ? nullptr : call->getArg(i);
  }
  const std::optional<FillingCall> filling = filling_call(unit, call);
  return filling && llvm::isa<clang::CXXMemberCallExpr>(call) ? filling->message : nullptr;
}

}  // namespace

const clang::Expr* filled_message(const Unit& unit, const clang::Stmt* stmt) {
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  const clang::Expr* filled = call ? filled_by(unit, call) : nullptr;
  return filled && message_of(filled->getType().getNonReferenceType()) ? filled : nullptr;
}

bool is_cloud_iterator(const clang::CXXRecordDecl* record) {
  return record && record->getName().starts_with("PointCloud2") && record->getName().ends_with("Iterator");
}

namespace {

bool holds_cloud_iterators(const clang::CXXRecordDecl* container) {
  const auto* made = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(container);
  return made && llvm::any_of(made->getTemplateArgs().asArray(), [](const clang::TemplateArgument& held) {
           const clang::CXXRecordDecl* record = held.getKind() == clang::TemplateArgument::Type
                                                    ? held.getAsType()->getAsCXXRecordDecl()
                                                    : nullptr;
           return is_cloud_iterator(record) && !record->getName().contains("Const");
         });
}

/// Also in a std::forward_as_tuple(...) among them.
const clang::Expr* message_among(llvm::ArrayRef<const clang::Expr*> arguments) {
  for (const clang::Expr* argument : arguments) {
    if (message_of(argument->getType().getNonReferenceType())) return argument;
    const auto* call = llvm::dyn_cast<clang::CallExpr>(argument->IgnoreImplicit());
    if (const clang::Expr* inner = call ? message_among({call->getArgs(), call->getNumArgs()}) : nullptr)
      return inner;
  }
  return nullptr;
}

}  // namespace

const clang::Expr* cloud_of_emplaced_iterator(const clang::Stmt* stmt) {
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(stmt);
  const clang::CXXMethodDecl* method = call ? call->getMethodDecl() : nullptr;
  const bool makes = method && method->getIdentifier() && method->getName().contains("emplace");
  if (!makes || !holds_cloud_iterators(method->getParent())) return nullptr;
  return message_among({call->getArgs(), call->getNumArgs()});
}

}  // namespace tzc::rewriter
