// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/named_elements.h"

#include <clang/AST/ExprCXX.h>
#include <llvm/ADT/STLExtras.h>

#include <set>

#include "facts/syntax/message_type.h"
#include "parse/names.h"

namespace tzc::rewriter {
namespace {

bool lies_in(const clang::Stmt* part, const clang::Stmt* whole) {
  return whole && (whole == part || llvm::any_of(whole->children(), [&](const clang::Stmt* child) {
                     return lies_in(part, child);
                   }));
}

std::string class_of(clang::QualType type) {
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return record ? qualified_name_of(record) : "";
}

/// The list that has one expression for each element, whether its braces are written or not; null: there is none.
const clang::InitListExpr* elements_of(clang::QualType type, const clang::Expr* value) {
  if (!value) return nullptr;
  value = value->IgnoreImplicit();
  const std::string name = class_of(type);
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(value)) {
    if ((name != "std::vector" && name != "std::deque") || construct->getNumArgs() == 0) return nullptr;
    const auto* given =
        llvm::dyn_cast<clang::CXXStdInitializerListExpr>(construct->getArg(0)->IgnoreImplicit());
    return given ? llvm::dyn_cast<clang::InitListExpr>(given->getSubExpr()->IgnoreImplicit()) : nullptr;
  }
  const auto* list = llvm::dyn_cast<clang::InitListExpr>(value);
  if (list && !list->isSemanticForm()) list = list->getSemanticForm();
  if (!list || type->isArrayType()) return list;
  return name == "std::array" && list->getNumInits() == 1
             ? elements_of(list->getInit(0)->getType(), list->getInit(0))
             : nullptr;
}

std::string element_name(const clang::VarDecl* variable, unsigned index) {
  return variable->getNameAsString() + "[" + std::to_string(index) + "]";
}

/// Whether `*variable` is no message, or that of the first pointer alone.
bool holds_several(clang::QualType type) {
  static const std::set<std::string> classes = {
      "std::array",        "std::vector",   "std::deque",         "std::list",
      "std::forward_list", "std::set",      "std::unordered_set", "std::map",
      "std::pair",         "std::optional", "std::tuple",         "std::unordered_map"};
  type = type.getNonReferenceType();
  return type->isArrayType() || classes.count(class_of(type)) != 0;
}

}  // namespace

std::string name_of_made(const clang::VarDecl* variable, const clang::Expr* made) {
  if (!holds_several(variable->getType())) return "*" + variable->getNameAsString();
  const clang::InitListExpr* list = elements_of(variable->getType(), variable->getInit());
  if (!list || variable->getType()->isReferenceType()) return "";
  for (unsigned index = 0; index < list->getNumInits(); ++index) {
    const clang::Expr* element = list->getInit(index);
    const clang::QualType message = pointee_of(element->getType());
    if (lies_in(made, element))
      return !message.isNull() && message_of(message) ? "*" + element_name(variable, index) : "";
  }
  return "";
}

}  // namespace tzc::rewriter
