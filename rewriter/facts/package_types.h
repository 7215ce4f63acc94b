// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facts/unit.h"

namespace tzc::rewriter {

/// Whether a record of the package takes part in a type, so that code of a library that handles objects of the
/// type may call the package.
bool involves_package(const Unit& unit, clang::QualType type);
/// The type of the object that ends with a variable: of a temporary, too, that the variable is a reference to.
clang::QualType object_type_of(const clang::VarDecl* variable);

}  // namespace tzc::rewriter
