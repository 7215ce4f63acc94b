// SPDX-License-Identifier: BSD-3-Clause
#include "facts/package_types.h"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>

#include <vector>

namespace tzc::rewriter {
namespace {

bool involves(const Unit& unit, clang::QualType type, unsigned depth);

/// A functor, a comparison: what a library may call although the class is trivially copied.
bool has_operators(const clang::CXXRecordDecl* record) {
  return llvm::any_of(record->methods(),
                      [](const clang::CXXMethodDecl* method) {
                        return method->isOverloadedOperator() && method->isUserProvided();
                      }) ||
         llvm::any_of(record->bases(), [](const clang::CXXBaseSpecifier& base) {
           const clang::CXXRecordDecl* parent = base.getType()->getAsCXXRecordDecl();
           return !parent || !parent->hasDefinition() || has_operators(parent->getDefinition());
         });
}

bool involves(const Unit& unit, const clang::TemplateArgument& argument, unsigned depth) {
  if (argument.getKind() == clang::TemplateArgument::Type) return involves(unit, argument.getAsType(), depth);
  return argument.getKind() == clang::TemplateArgument::Pack &&
         llvm::any_of(argument.pack_elements(),
                      [&](const clang::TemplateArgument& part) { return involves(unit, part, depth); });
}

bool involves(const Unit& unit, clang::QualType type, unsigned depth) {
  if (type.isNull() || depth > 5) return depth > 5;
  type = type.getNonReferenceType().getCanonicalType();
  if (type->isPointerType() || type->isMemberPointerType())
    return type->isFunctionPointerType() || type->isMemberFunctionPointerType() ||
           involves(unit, type->getPointeeType(), depth + 1);
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record) return false;
  if (unit.source.in_package(record->getLocation()))
    return !record->hasDefinition() || !record->isTrivial() || record->isLambda() ||
           has_operators(record->getDefinition());
  if (record->getName() == "function" || record->getName() == "_Bind") return true;
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  return made && llvm::any_of(made->getTemplateArgs().asArray(), [&](const clang::TemplateArgument& one) {
           return involves(unit, one, depth + 1);
         });
}

}  // namespace

bool involves_package(const Unit& unit, clang::QualType type) {
  return involves(unit, type, 0);
}

clang::QualType object_type_of(const clang::VarDecl* variable) {
  if (!variable->getType()->isReferenceType() || !variable->getInit()) return variable->getType();
  std::vector<const clang::Stmt*> open{variable->getInit()};
  while (!open.empty()) {
    const clang::Stmt* stmt = open.back();
    open.pop_back();
    const auto* made = llvm::dyn_cast_or_null<clang::MaterializeTemporaryExpr>(stmt);
    if (made && made->getExtendingDecl() == variable) return made->getType();
    if (stmt) open.insert(open.end(), stmt->child_begin(), stmt->child_end());
  }
  return variable->getType();
}

}  // namespace tzc::rewriter
