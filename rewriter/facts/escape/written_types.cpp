// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/written_types.h"

#include <clang/AST/ASTContext.h>

#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

/// typename M::_data_type in an instance of a template
bool is_of_argument(const clang::NestedNameSpecifier* qualifier) {
  for (; qualifier; qualifier = qualifier->getPrefix())
    if (const clang::Type* type = qualifier->getAsType();
        type && llvm::isa<clang::SubstTemplateTypeParmType>(type))
      return true;
  return false;
}

bool follows_from_value(const clang::Type* type) {
  const auto* named = llvm::dyn_cast<clang::ElaboratedType>(type);
  return llvm::isa<clang::DeducedType, clang::DecltypeType, clang::TypeOfExprType,
                   clang::SubstTemplateTypeParmType>(type) ||
         (named && is_of_argument(named->getQualifier()));
}

}  // namespace

bool is_written_out(const clang::ASTContext& ast, clang::QualType type) {
  for (;;) {
    if (follows_from_value(type.getTypePtr())) return false;
    const clang::QualType next = type.getSingleStepDesugaredType(ast);
    if (next == type) return true;
    type = next;
  }
}

bool is_pointee_written_out(const clang::ASTContext& ast, clang::QualType type) {
  while (is_written_out(ast, type))
    // T&& with T = std::vector<float>& is the reference that T is.
    if (const auto* reference = type->getAs<clang::ReferenceType>())
      type = reference->getPointeeTypeAsWritten();
    else if (type->isPointerType())
      type = type->getPointeeType();
    else
      return true;
  return false;
}

bool names_array(clang::QualType type) {
  while (type->isPointerType() || type->isReferenceType()) type = type->getPointeeType();
  return is_data_array(type);
}

}  // namespace tzc::rewriter
