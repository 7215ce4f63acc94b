// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Type.h>

#include "facts/flow/entity_table.h"
#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// sizeof, alignof or offsetof a class of the package: the messages in it may not change their size.
void note_size_question(const Unit& unit, EntityTable& entities, clang::QualType type,
                        clang::SourceLocation where);

}  // namespace tzc::rewriter
