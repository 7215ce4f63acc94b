// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/size_questions.h"

#include <clang/AST/DeclCXX.h>

#include "facts/syntax/message_type.h"
#include "model/codes.h"

namespace tzc::rewriter {

void note_size_question(const Unit& unit, EntityTable& entities, clang::QualType type,
                        clang::SourceLocation where) {
  while (const clang::ArrayType* array = unit.ast().getAsArrayType(type)) type = array->getElementType();
  const clang::CXXRecordDecl* record = type->isDependentType() ? nullptr : type->getAsCXXRecordDecl();
  if (!record || !record->hasDefinition() || !unit.source.in_package(record->getLocation())) return;
  record = record->getDefinition();
  for (const clang::CXXBaseSpecifier& base : record->bases())
    note_size_question(unit, entities, base.getType(), where);
  for (const clang::FieldDecl* field : record->fields()) {
    const EntityId id = message_of(field->getType()) ? entities.declare(field) : EntityId();
    if (!id.empty())
      entities.add_obstacle(id, codes::TZC1001, "the program asks for the size of a class that holds it",
                            where);
    note_size_question(unit, entities, field->getType(), where);
  }
}

}  // namespace tzc::rewriter
