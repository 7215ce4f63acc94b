// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/package_types.h"

#include <clang/AST/Attr.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>

namespace tzc::rewriter {
namespace {

bool involves(const Unit& unit, clang::QualType type, unsigned depth);

/// allocator.allocate(n)
bool is_called_by_name(const clang::CXXMethodDecl* method) {
  return method->getIdentifier() && (method->getName() == "allocate" || method->getName() == "deallocate");
}

/// A functor, a comparison, a conversion, an allocator, traits: what a library may call although the class is trivially copied.
bool has_operators(const clang::CXXRecordDecl* record) {
  return llvm::any_of(record->methods(),
                      [](const clang::CXXMethodDecl* method) {
                        return method->isUserProvided() &&
                               (method->isOverloadedOperator() || is_called_by_name(method) ||
                                llvm::isa<clang::CXXConversionDecl>(method));
                      }) ||
         llvm::any_of(record->bases(), [](const clang::CXXBaseSpecifier& base) {
           const clang::CXXRecordDecl* parent = base.getType()->getAsCXXRecordDecl();
           return !parent || !parent->hasDefinition() || parent->isInStdNamespace() ||
                  has_operators(parent->getDefinition());
         });
}

/// A parameter of the class or enumeration, by reference or not, or of any type.
bool takes(const clang::ParmVarDecl* parameter, const clang::TagDecl* tag) {
  const clang::QualType type = parameter->getType().getNonReferenceType().getCanonicalType();
  if (type->isTemplateTypeParmType()) return true;
  const auto* made = type->getAs<clang::TemplateSpecializationType>();
  const auto* of_template = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(tag);
  if (made && of_template)
    return made->getTemplateName().getAsTemplateDecl() == of_template->getSpecializedTemplate();
  const clang::TagDecl* taken = type->getAsTagDecl();
  return taken && taken->getCanonicalDecl() == tag->getCanonicalDecl();
}

/// Of the namespace of a class or enumeration, or of its bases.
bool has_functions_beside_it(const Unit& unit, const clang::TagDecl* tag) {
  if (!functions_beside(unit, tag).empty()) return true;
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(tag);
  return record && record->hasDefinition() &&
         llvm::any_of(record->bases(), [&](const clang::CXXBaseSpecifier& base) {
           const clang::TagDecl* parent = base.getType()->getAsTagDecl();
           return !parent || has_functions_beside_it(unit, parent);
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
  type = unit.ast().getBaseElementType(type.getNonReferenceType()).getCanonicalType();
  if (type->isPointerType() || type->isMemberPointerType())
    return type->isFunctionPointerType() || type->isMemberFunctionPointerType() ||
           involves(unit, type->getPointeeType(), depth + 1);
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record) return type->isEnumeralType() && has_functions_beside_it(unit, type->getAsTagDecl());
  if (unit.source.in_package(record->getLocation()))
    return !record->hasDefinition() || !record->isTrivial() || record->isLambda() ||
           has_operators(record->getDefinition()) || has_functions_beside_it(unit, record);
  if (record->getName() == "function" || record->getName() == "_Bind") return true;
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  return made && llvm::any_of(made->getTemplateArgs().asArray(), [&](const clang::TemplateArgument& one) {
           return involves(unit, one, depth + 1);
         });
}

}  // namespace

std::vector<const clang::FunctionDecl*> functions_beside(const Unit& unit, const clang::TagDecl* tag) {
  clang::ASTContext& ast = unit.ast();
  std::vector<clang::DeclarationName> names{&ast.Idents.get("swap")};
  for (int op = clang::OO_None + 1; op < clang::NUM_OVERLOADED_OPERATORS; ++op)
    names.push_back(ast.DeclarationNames.getCXXOperatorName(static_cast<clang::OverloadedOperatorKind>(op)));
  std::vector<const clang::FunctionDecl*> functions;
  const clang::DeclContext* space = tag->getEnclosingNamespaceContext();
  for (const clang::DeclarationName name : names)
    for (const clang::NamedDecl* found : space->lookup(name)) {
      const clang::FunctionDecl* function = found->getAsFunction();
      if (function && unit.source.in_package(function->getLocation()) &&
          llvm::any_of(function->parameters(),
                       [&](const clang::ParmVarDecl* parameter) { return takes(parameter, tag); }))
        functions.push_back(function);
    }
  return functions;
}

bool involves_package(const Unit& unit, clang::QualType type) {
  return involves(unit, type, 0);
}

bool parts_involve_package(const Unit& unit, const clang::CXXRecordDecl* record) {
  if (!record->hasDefinition()) return true;
  return llvm::any_of(record->fields(),
                      [&](const clang::FieldDecl* f) { return involves_package(unit, f->getType()); }) ||
         llvm::any_of(record->bases(), [&](const clang::CXXBaseSpecifier& base) {
           return involves_package(unit, base.getType());
         });
}

bool may_end_derived(const clang::CXXDestructorDecl* destructor) {
  return destructor->isVirtual() && !destructor->hasAttr<clang::FinalAttr>() &&
         !destructor->getParent()->isEffectivelyFinal();
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
