// SPDX-License-Identifier: BSD-3-Clause
// How a type is written, and how it is written once ported.
#include <clang/AST/TypeLoc.h>

#include "facts/unit.h"
#include "report/codes.h"

namespace tzc::rewriter {
namespace {

struct Spelling {
  std::string text, header, rule;
};

std::string pointer_name(const std::string& twin, clang::QualType type) {
  const clang::QualType pointee = pointee_of(type);
  const auto* record = type.getCanonicalType()->getAsCXXRecordDecl();
  if (record && record->getName() == "shared_ptr" && !record->isInStdNamespace())
    return twin + (pointee.isConstQualified() ? "ConstPtr" : "Ptr");
  const std::string name = record ? qualified_name_of(record) : "";
  if (name.empty()) return "";
  return name + "<" + twin + (pointee.isConstQualified() ? " const>" : ">");
}

/// The ported name of a type that is written as one name; empty when there is none.
std::optional<Spelling> ported_name(Unit& unit, clang::QualType type) {
  const clang::CXXRecordDecl* record = type.getCanonicalType()->getAsCXXRecordDecl();
  if (record)
    if (const ClassRename* rename = unit.rules.find_class(qualified_name_of(record)))
      return Spelling{rename->to, rename->header, rename->rule};
  if (const auto message = message_of(type); message && !type->isReferenceType())
    return Spelling{twin_name(message->name), twin_header(message->name), "message-type"};
  const clang::QualType pointee = pointee_of(type);
  if (pointee.isNull() || type->isPointerType()) return {};
  const auto message = message_of(pointee);
  if (!message) return {};
  return Spelling{pointer_name(twin_name(message->name), type), twin_header(message->name), "message-type"};
}

void add_change(Entity& entity, Place where, const Spelling& spelling, const std::string& old_text) {
  Change change{std::move(where), spelling.text, spelling.rule, {spelling.header}};
  const std::string prefix = "tzc::";
  const std::string package = spelling.text.rfind(prefix, 0) == 0
                                  ? spelling.text.substr(5, spelling.text.find("::", 5) - 5) + "::"
                                  : "";
  const bool same_name = spelling.text == prefix + old_text;
  const bool same_package =
      spelling.rule == "message-type" && !package.empty() && old_text.rfind(package, 0) == 0;
  if (same_name || same_package) {
    change.where.end = change.where.begin;
    change.text = prefix;
  } else if (!package.empty() && old_text.rfind("::" + package, 0) == 0) {
    change.where.end = change.where.begin;
    change.text = "::tzc";
  }
  for (const Change& known : entity.changes)
    if (known.where.file == change.where.file && known.where.begin == change.where.begin) return;
  entity.changes.push_back(std::move(change));
}

void obstruct(Unit& unit, Entity& entity, const char* code, const std::string& reason,
              clang::SourceLocation where) {
  for (const Obstacle& known : entity.obstacles)
    if (known.code == code) return;
  entity.obstacles.push_back({code, reason, location_of(unit.source.where(where))});
}

void change_name(Unit& unit, clang::SourceRange tokens, const Spelling& spelling, Entity& entity) {
  if (const std::optional<Place> where = unit.source.place(tokens))
    return add_change(entity, *where, spelling, unit.source.text(*where));
  obstruct(unit, entity, codes::TZC1006, "its type is written by a macro", tokens.getBegin());
}

void retype_template(Unit& unit, clang::TemplateSpecializationTypeLoc type, clang::SourceLocation begin,
                     Entity& entity) {
  const clang::CXXRecordDecl* record = type.getType().getCanonicalType()->getAsCXXRecordDecl();
  if (record)
    if (const ClassRename* rename = unit.rules.find_class(qualified_name_of(record)))
      return change_name(unit, {begin, type.getTemplateNameLoc()}, {rename->to, rename->header, rename->rule},
                         entity);
  for (unsigned i = 0; i < type.getNumArgs(); ++i)
    if (clang::TypeSourceInfo* argument = type.getArgLoc(i).getTypeSourceInfo())
      retype(unit, argument->getTypeLoc(), entity);
}

void retype_name(Unit& unit, clang::TypeLoc type, clang::SourceRange tokens, Entity& entity) {
  if (type.getAs<clang::SubstTemplateTypeParmTypeLoc>() || type.getAs<clang::TemplateTypeParmTypeLoc>())
    return;
  if (const auto spelling = ported_name(unit, type.getType()); spelling && !spelling->text.empty())
    return change_name(unit, tokens, *spelling, entity);
  if (carried_by(type.getType(), unit.rules))
    obstruct(unit, entity, codes::TZC1005,
             "its type hides behind the name '" + unit.source.text(tokens) + "'", tokens.getBegin());
}

}  // namespace

void retype(Unit& unit, clang::TypeLoc type, Entity& entity) {
  const clang::SourceRange tokens = type.getSourceRange();
  if (type.isNull() || tokens.isInvalid() || entity.ported) return;
  if (const auto qualified = type.getAs<clang::QualifiedTypeLoc>())
    return retype(unit, qualified.getUnqualifiedLoc(), entity);
  if (const auto pointer = type.getAs<clang::PointerTypeLoc>())
    return retype(unit, pointer.getPointeeLoc(), entity);
  if (const auto reference = type.getAs<clang::ReferenceTypeLoc>())
    return retype(unit, reference.getPointeeLoc(), entity);
  if (const auto array = type.getAs<clang::ArrayTypeLoc>())
    return retype(unit, array.getElementLoc(), entity);
  if (const auto parens = type.getAs<clang::ParenTypeLoc>())
    return retype(unit, parens.getInnerLoc(), entity);
  if (type.getAs<clang::AutoTypeLoc>() || type.getAs<clang::DecltypeTypeLoc>()) return;
  const auto elaborated = type.getAs<clang::ElaboratedTypeLoc>();
  const clang::TypeLoc named = elaborated ? elaborated.getNamedTypeLoc() : type;
  if (const auto templated = named.getAs<clang::TemplateSpecializationTypeLoc>())
    return retype_template(unit, templated, tokens.getBegin(), entity);
  retype_name(unit, named, tokens, entity);
}

}  // namespace tzc::rewriter
