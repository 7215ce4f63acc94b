// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/started_pointers.h"

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/calls.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

/// Of a constructor that the program has written.
bool starts(const clang::CXXConstructorDecl* constructor, const clang::FieldDecl* field) {
  const clang::FunctionDecl* definition = nullptr;
  if (!constructor->isUserProvided() || constructor->isCopyOrMoveConstructor()) return false;
  if (!constructor->hasBody(definition)) return true;
  return llvm::any_of(llvm::cast<clang::CXXConstructorDecl>(definition)->inits(),
                      [&](const clang::CXXCtorInitializer* one) {
                        return one->getMember() == field && starts_with_new_message(one->getInit());
                      });
}

bool may_start(const clang::CXXRecordDecl* record, const clang::FieldDecl* field) {
  return (field->hasInClassInitializer() && starts_with_new_message(field->getInClassInitializer())) ||
         llvm::any_of(record->ctors(), [&](const auto* one) { return starts(one, field); });
}

}  // namespace

bool starts_with_new_message(const clang::Expr* initializer) {
  if (!initializer) return false;
  const clang::Expr* made = initializer->IgnoreParens()->IgnoreImplicit();
  if (made != initializer) return starts_with_new_message(made);
  if (const auto* by_default = llvm::dyn_cast<clang::CXXDefaultInitExpr>(made))
    return starts_with_new_message(by_default->getExpr());
  if (const auto* object = llvm::dyn_cast<clang::CXXNewExpr>(made))
    return is_stock_or_twin(object->getAllocatedType());
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(made))
    return makes_object(call) && is_message_or_pointer(call->getType());
  if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(made))
    return starts_with_new_message(cast->getSubExpr());
  if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(made))
    return starts_with_new_message(choice->getTrueExpr()) || starts_with_new_message(choice->getFalseExpr());
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(made))
    return list->getNumInits() == 1 && starts_with_new_message(list->getInit(0));
  const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(made);
  return construct && construct->getNumArgs() > 0 && starts_with_new_message(construct->getArg(0));
}

std::vector<const clang::FieldDecl*> started_pointers(const Unit& unit, const clang::CXXRecordDecl* record) {
  std::vector<const clang::FieldDecl*> found;
  if (!record || !record->hasDefinition() || !unit.source.in_package(record->getLocation())) return found;
  record = record->getDefinition();
  const auto add = [&](clang::QualType type) {
    const auto more = started_pointers(unit, type->getAsCXXRecordDecl());
    found.insert(found.end(), more.begin(), more.end());
  };
  for (const clang::CXXBaseSpecifier& base : record->bases()) add(base.getType());
  for (const clang::FieldDecl* field : record->fields()) {
    const clang::QualType pointee = pointee_of(field->getType());
    if (pointee.isNull())
      add(field->getType());
    else if (is_stock_or_twin(pointee) && may_start(record, field))
      found.push_back(field);
  }
  return found;
}

}  // namespace tzc::rewriter
