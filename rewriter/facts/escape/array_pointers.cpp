// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/array_pointers.h"

#include <clang/AST/DeclTemplate.h>

#include "facts/escape/written_types.h"
#include "parse/names.h"

namespace tzc::rewriter {

bool is_pair(clang::QualType type) {
  const clang::CXXRecordDecl* record = type.getNonReferenceType()->getAsCXXRecordDecl();
  return record && qualified_name_of(record) == "std::pair";
}

bool points_to_array(clang::QualType type) {
  if (is_pair(type)) {
    const auto* pair = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(
        type.getNonReferenceType()->getAsCXXRecordDecl());
    return pair && llvm::any_of(pair->getTemplateArgs().asArray(), [](const clang::TemplateArgument& part) {
             return part.getKind() == clang::TemplateArgument::Type && points_to_array(part.getAsType());
           });
  }
  return (type->isPointerType() || type->isReferenceType()) && names_array(type);
}

}  // namespace tzc::rewriter
