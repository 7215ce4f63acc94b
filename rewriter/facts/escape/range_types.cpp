// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/range_types.h"

#include <clang/AST/DeclTemplate.h>

#include "facts/escape/escape.h"
#include "facts/syntax/known_functions.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {

clang::QualType named_in(const clang::CXXRecordDecl* record, llvm::StringRef name) {
  if (!record || !record->hasDefinition()) return {};
  for (const clang::Decl* decl : record->decls())
    if (const auto* alias = llvm::dyn_cast<clang::TypedefNameDecl>(decl); alias && alias->getName() == name)
      return alias->getUnderlyingType().getCanonicalType();
  for (const clang::CXXBaseSpecifier& base : record->bases())
    if (const clang::QualType found = named_in(base.getType()->getAsCXXRecordDecl(), name); !found.isNull())
      return found;
  return {};
}

namespace {

/// Of an iterator, or of one that inserts into a container; null: it is none.
clang::QualType element_of(const clang::CXXRecordDecl* iterator) {
  const clang::QualType value = named_in(iterator, "value_type");
  if (!value.isNull() && !value->isVoidType()) return value;
  const clang::QualType container = named_in(iterator, "container_type");
  if (container.isNull()) return {};
  const clang::QualType element = named_in(container->getAsCXXRecordDecl(), "value_type");
  return element.isNull() ? container : element;
}

/// Of std::reference_wrapper<T>, std::pair<T, U>.
bool leads_to_pointers(const clang::TemplateArgument& argument) {
  if (argument.getKind() != clang::TemplateArgument::Type) return false;
  const clang::QualType type = argument.getAsType().getCanonicalType();
  if (type->isPointerType()) return may_hold_pointer(type->getPointeeType());
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return record && is_owner_class(qualified_name_of(record)) && may_hold_pointer(type);
}

}  // namespace

bool is_known_iterator(clang::QualType type) {
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return is_view(type) && record && !named_in(record, "iterator_category").isNull();
}

clang::QualType element_type(clang::QualType reference) {
  clang::QualType type = reference.getNonReferenceType().getCanonicalType();
  if (type->isPointerType()) type = type->getPointeeType();
  if (is_data_array(type)) return first_argument(type);
  if (type->isArithmeticType() || message_of(type)) return type;
  return is_known_iterator(type) ? element_of(type->getAsCXXRecordDecl()) : clang::QualType();
}

bool reaches_pointers(clang::QualType type) {
  type = type.getNonReferenceType().getCanonicalType();
  if (type->isArrayType()) return may_hold_pointer(type);
  if (type->isVoidPointerType() || type->isFunctionPointerType()) return false;
  if (type->isPointerType()) return may_hold_pointer(type->getPointeeType());
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record) return false;
  if (is_owner_class(qualified_name_of(record))) return may_hold_pointer(type);
  const clang::QualType element = element_of(record);
  if (!element.isNull()) return may_hold_pointer(element);
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  return made && is_view_class(qualified_name_of(record)) &&
         llvm::any_of(made->getTemplateArgs().asArray(), leads_to_pointers);
}

}  // namespace tzc::rewriter
