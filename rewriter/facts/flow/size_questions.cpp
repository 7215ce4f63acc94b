// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/size_questions.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/DeclTemplate.h>

#include <set>
#include <vector>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/message_type.h"
#include "facts/syntax/type_blind.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

/// Only what is as large can hold the other by value: std::optional<Image>, std::array<Image, 2>; not std::vector<Image>.
bool has_room_for(const Unit& unit, clang::QualType type, clang::QualType part) {
  const auto is_whole = [](clang::QualType one) {
    return !one->isDependentType() && !one->isIncompleteType();
  };
  return is_whole(type) && is_whole(part) && part->isObjectType() &&
         unit.ast().getTypeSizeInChars(part) <= unit.ast().getTypeSizeInChars(type);
}

/// The types that a library's class may hold by value; a class of the package, or a message, is looked at by itself.
void add_parts(const Unit& unit, clang::QualType type, std::vector<clang::QualType>& parts) {
  while (const clang::ArrayType* array = unit.ast().getAsArrayType(type)) type = array->getElementType();
  const auto* made =
      llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
  if (!made || message_of(type) || unit.source.in_package(made->getLocation())) return parts.push_back(type);
  std::vector<clang::TemplateArgument> open = made->getTemplateArgs().asArray().vec();
  while (!open.empty()) {
    const clang::TemplateArgument argument = open.back();
    open.pop_back();
    if (argument.getKind() == clang::TemplateArgument::Pack)
      open.insert(open.end(), argument.pack_begin(), argument.pack_end());
    else if (argument.getKind() == clang::TemplateArgument::Type &&
             has_room_for(unit, type, argument.getAsType()))
      add_parts(unit, argument.getAsType(), parts);
  }
}

class SizeQuestion {
 public:
  SizeQuestion(const Unit& unit, EntityTable& entities, clang::SourceLocation where)
      : unit_(unit), entities_(entities), where_(where) {}

  void about(clang::QualType type) {
    while (const clang::ArrayType* array = unit_.ast().getAsArrayType(type)) type = array->getElementType();
    const clang::CXXRecordDecl* record = type->isDependentType() ? nullptr : type->getAsCXXRecordDecl();
    if (!record || !record->hasDefinition() || !unit_.source.in_package(record->getLocation())) return;
    record = record->getDefinition();
    if (!seen_.insert(record).second) return;  // struct Tree { std::vector<Tree> trees; };
    for (const clang::CXXBaseSpecifier& base : record->bases()) about(base.getType());
    for (const clang::FieldDecl* field : record->fields()) about(field);
  }

 private:
  void about(const clang::FieldDecl* field) {
    std::vector<clang::QualType> parts;
    add_parts(unit_, field->getType(), parts);
    for (const clang::QualType part : parts) {
      const EntityId id = message_of(part) ? entities_.declare(field) : EntityId();
      if (!id.empty())
        entities_.add_obstacle(id, codes::TZC1001, "the program asks for the size of a class that holds it",
                               where_);
      about(part);
    }
  }

  const Unit& unit_;
  EntityTable& entities_;
  const clang::SourceLocation where_;
  std::set<const clang::CXXRecordDecl*> seen_;
};

}  // namespace

void note_size_question(const Unit& unit, EntityTable& entities, clang::QualType type,
                        clang::SourceLocation where) {
  SizeQuestion(unit, entities, where).about(type);
}

void note_signature_question(const Unit& unit, EntityTable& entities, const clang::PredefinedExpr* name) {
  if (!tells_signature(unit, name)) return;
  const auto ask = [&](const EntityId& id) {
    if (!id.empty())
      entities.add_obstacle(id, entities.is_message(id) ? codes::TZC1001 : codes::TZC1010,
                            "the program asks for the text of its function's signature", name->getLocation());
  };
  const clang::DeclContext* around = enclosing_function(unit.ast(), *name);
  for (; around; around = around->getParent())
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(around)) {
      if (function->isDependentContext()) continue;  // its instances tell
      for (const clang::ParmVarDecl* parameter : function->parameters()) ask(entities.declare(parameter));
      if (!llvm::isa<clang::CXXDestructorDecl>(function)) ask(entities.declare_result(function));
    }
}

}  // namespace tzc::rewriter
