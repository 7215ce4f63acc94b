// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/named_elements.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>
#include <llvm/ADT/STLExtras.h>

#include <algorithm>
#include <set>

#include "parse/names.h"

namespace tzc::rewriter {
namespace {

/// More statements than that would be hard to read.
constexpr std::uint64_t few = 4;

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

/// An array's, or a std::array's.
struct Elements {
  clang::QualType type;
  std::uint64_t number = 0;
};
Elements elements_in(const clang::VarDecl* variable) {
  const clang::ASTContext& ast = variable->getASTContext();
  const clang::QualType type = variable->getType();
  if (const auto* array = ast.getAsConstantArrayType(type))
    return {array->getElementType(), array->getSize().getZExtValue()};
  const auto* record =
      llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
  if (class_of(type) != "std::array" || record->getTemplateArgs().size() != 2) return {};
  const clang::TemplateArgumentList& arguments = record->getTemplateArgs();
  if (arguments[0].getKind() != clang::TemplateArgument::Type ||
      arguments[1].getKind() != clang::TemplateArgument::Integral)
    return {};
  return {arguments[0].getAsType(), arguments[1].getAsIntegral().getZExtValue()};
}

std::string element_name(const clang::VarDecl* variable, std::uint64_t index) {
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

/// Not Image images[2] = {a, b}: the elements are copies.
bool starts_empty(const clang::VarDecl* variable) {
  const clang::Expr* value = variable->getInit() ? variable->getInit()->IgnoreImplicit() : nullptr;
  const auto* construct = llvm::dyn_cast_or_null<clang::CXXConstructExpr>(value);
  return !value || (construct && construct->getNumArgs() == 0);
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

std::vector<std::string> few_messages_in(const clang::VarDecl* variable) {
  const Elements elements = elements_in(variable);
  std::vector<std::string> names;
  if (elements.type.isNull() || elements.type->isAnyPointerType() || !message_of(elements.type)) return names;
  if (elements.number > few || !starts_empty(variable)) return names;
  for (std::uint64_t index = 0; index < elements.number; ++index)
    names.push_back(element_name(variable, index));
  return names;
}

std::optional<MessageType> message_declared_by(const clang::VarDecl* variable) {
  return message_of(few_messages_in(variable).empty() ? variable->getType() : elements_in(variable).type);
}

}  // namespace tzc::rewriter
